// SPDX-License-Identifier: Apache-2.0
#include "simplify/limb_mouths.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "simplify/cut_parts.h"
#include "simplify/mouth_chords.h"

namespace inkflate {
namespace {

// What a mouth must add, as a share of the limb's area, and of the square of the mouth's width: less is a bulge, not a stretch of limb.
constexpr double kLeastGrowth = 0.03;
constexpr double kLeastStretch = 0.2;

// The same for strokes that have enclosed nothing so far; a flat foot is an arc.
constexpr double kLeastArc = 0.08;

// Of a mouth's width must become outline that was none before: the sides of the stretch. A bay between two tips that are over another part has
// none, for its rim is outline already.
constexpr double kLeastSides = 0.4;
constexpr double kSameLinePx = 8;

// In any case a mouth must add this much, work px squared.
constexpr double kLeastAreaPx2 = 150;

// Of the new limb's strokes must lie beyond the other parts: a smile in a group of its own is no limb of the head.
constexpr double kOutsideShare = 0.4;

// A limb that is closed anew still has its old outline within it, or no farther outside than this, work px.
constexpr double kMovedPx = 16;
constexpr double kKeptShare = 0.95;

// More mouths at one limb are not looked for.
constexpr int kMostMouths = 4;

/// What a limb encloses, and how much ink encloses it where its outline has not been before.
struct Extent {
  double area_px2 = 0;
  double new_ink_px = 0;
};

/// A chord, and by how much it makes the limb larger, work px squared.
struct Candidate {
  MouthChord mouth;
  double gain_px2;
};

Extent measure(CutParts const& cut, LayerArea const* own) {
  Extent extent;
  for (auto const& part : cut.parts) {
    for (auto const& rim : part) {
      auto const contour = positions(rim, cut.cells.samples);
      extent.area_px2 += signed_area(contour);
      for (std::size_t i = 0; i < rim.size(); ++i) {
        if (rim[i].to_next == RunKind::Closing) continue;
        if (own != nullptr && own->is_at_rim(contour[i], kSameLinePx)) continue;
        extent.new_ink_px += distance(contour[i], contour[(i + 1) % contour.size()]);
      }
    }
  }
  return extent;
}

/// Closes the limbs of one group.
class MouthCloser {
 public:
  MouthCloser(Sketch const& sketch, std::span<LayerArea const* const> hosts, WorkSpace const& space,
              SimplifyOptions const& options, Progress const& progress)
      : sketch_(sketch),
        hosts_(hosts),
        space_(space),
        options_(options),
        progress_(progress),
        quiet_{{}, progress.is_cancelled} {}

  /// The layers of the limb with its mouths closed; none: nothing is gained.
  Result<std::vector<Layer>> close(Limb const& limb, LayerArea const* own) const {
    auto const samples = sample_strokes(sketch_, limb.strokes, space_, kCutSpacingPx);
    double const longest = options_.gap_px ? *options_.gap_px * space_.to_work
                                           : std::numeric_limits<double>::infinity();
    auto const mouths = mouth_chords(samples, loose_ends(sketch_, samples), hosts_, own, longest);
    if (mouths.empty() || (own == nullptr && !reaches_outside(samples)))
      return std::vector<Layer>{};
    if (!progress_.enter("mouths")) return cancelled();
    auto chosen = choose(samples, mouths, own);
    if (!chosen) return chosen.error();
    if (chosen->empty()) return std::vector<Layer>{};
    auto const cut = cut_along(samples, *chosen);
    if (!cut) return cut.error();
    if (own != nullptr && !keeps(*own, *cut)) return std::vector<Layer>{};
    return fit_parts(*cut, space_, options_.smooth, quiet_);
  }

 private:
  static Error cancelled() { return {ErrorCode::Cancelled, "stopped on request"}; }

  bool reaches_outside(StrokeSamples const& samples) const {
    auto const outside = std::count_if(
        samples.points.begin(), samples.points.end(), [&](StrokeSample const& sample) {
          return std::none_of(hosts_.begin(), hosts_.end(),
                              [&](LayerArea const* host) { return host->holds(sample.position); });
        });
    return static_cast<double>(outside) >=
           kOutsideShare * static_cast<double>(samples.points.size());
  }

  Result<CutParts> cut_along(StrokeSamples samples, std::vector<Chord> const& chords) const {
    int stroke = static_cast<int>(std::ssize(sketch_.strokes));
    for (auto const& chord : chords) append_chord(chord, stroke++, samples);
    return cut_parts(sketch_, std::move(samples), space_, options_, quiet_);
  }

  /// The chords that make the limb clearly larger, the best one first; no end twice.
  Result<std::vector<Chord>> choose(StrokeSamples const& samples,
                                    std::vector<MouthChord> const& mouths,
                                    LayerArea const* own) const {
    auto const before = cut_along(samples, {});
    if (!before) return before.error();
    auto base = measure(*before, own);
    if (own != nullptr) base.area_px2 = std::max(base.area_px2, signed_area(own->contour()));
    std::vector<Candidate> candidates;
    for (auto const& mouth : mouths) {
      auto const cut = cut_along(samples, {mouth.chord});
      if (!cut) return cut.error();
      auto const extent = measure(*cut, own);
      if (is_enough(base, extent, mouth.chord, own))
        candidates.push_back({mouth, extent.area_px2 - base.area_px2});
    }
    std::stable_sort(
        candidates.begin(), candidates.end(),
        [](Candidate const& a, Candidate const& b) { return a.gain_px2 > b.gain_px2; });
    std::vector<Chord> chosen;
    std::vector<int> used;
    for (auto const& candidate : candidates) {
      auto const& [chord, a, b] = candidate.mouth;
      bool const is_free = std::none_of(used.begin(), used.end(),
                                        [a = a, b = b](int end) { return end == a || end == b; });
      if (!is_free || std::ssize(chosen) == kMostMouths) continue;
      chosen.push_back(chord);
      auto const cut = cut_along(samples, chosen);
      if (!cut) return cut.error();
      auto const extent = measure(*cut, own);
      if (is_enough(base, extent, chord, own)) {
        base = extent;
        used.insert(used.end(), {a, b});
      } else {
        chosen.pop_back();
      }
    }
    return chosen;
  }

  static bool is_enough(Extent const& before, Extent const& after, Chord const& chord,
                        LayerArea const* own) {
    double const width = distance(chord.from, chord.to);
    double const stretch = (own != nullptr ? kLeastStretch : kLeastArc) * width * width;
    return after.area_px2 - before.area_px2 >=
               std::max({kLeastGrowth * before.area_px2, stretch, kLeastAreaPx2}) &&
           after.new_ink_px - before.new_ink_px >= kLeastSides * width;
  }

  /// Whether the limb as it was is a part of what it has become.
  static bool keeps(LayerArea const& own, CutParts const& cut) {
    std::vector<Contour> outers;
    std::vector<Vec2> all;
    for (auto const& part : cut.parts) {
      outers.push_back(positions(part.front(), cut.cells.samples));
      all.insert(all.end(), outers.back().begin(), outers.back().end());
    }
    PointGrid const grid(all, kMovedPx);
    auto const kept = std::count_if(own.contour().begin(), own.contour().end(), [&](Vec2 p) {
      return grid.any_near(p, kMovedPx, [&](int i) {
        return squared_norm(all[i] - p) <= kMovedPx * kMovedPx;
      }) || std::any_of(outers.begin(), outers.end(), [&](Contour const& outer) {
               return contains(outer, p);
             });
    });
    return static_cast<double>(kept) >= kKeptShare * static_cast<double>(own.contour().size());
  }

  Sketch const& sketch_;
  std::span<LayerArea const* const> hosts_;
  WorkSpace const& space_;
  SimplifyOptions const& options_;
  Progress const& progress_;
  Progress quiet_;
};

double area(Layer const& layer, double tolerance_px) {
  return signed_area(flatten(layer.outlines.front(), tolerance_px));
}

/// Closes the mouths of one group; none: the group stays as it is.
Result<std::optional<std::vector<Layer>>> close_group(
    Sketch const& sketch, GroupShapes const& group, std::span<LayerArea const> own,
    std::vector<bool> const& is_faint, WorkSpace const& space, MouthCloser const& closer) {
  if (group.strokes.empty()) return std::optional<std::vector<Layer>>();
  std::vector<Layer> layers;
  bool is_changed = false;
  for (auto const& limb : group_limbs(sketch, group, is_faint, space)) {
    auto closed = closer.close(limb, limb.layer >= 0 ? &own[limb.layer] : nullptr);
    if (!closed) return closed.error();
    is_changed = is_changed || !closed->empty();
    if (closed->empty() && limb.layer >= 0) layers.push_back(group.layers[limb.layer]);
    for (auto& layer : *closed) layers.push_back(std::move(layer));
  }
  if (!is_changed) return std::optional<std::vector<Layer>>();
  for (auto& layer : layers) {
    layer.strokes.clear();
    layer.details.clear();
  }
  double const tolerance_px = 0.5 * space.to_canvas;
  std::stable_sort(layers.begin(), layers.end(), [&](Layer const& a, Layer const& b) {
    return area(a, tolerance_px) > area(b, tolerance_px);
  });
  return std::optional(std::move(layers));
}

}  // namespace

Result<std::vector<int>> close_limb_mouths(Sketch const& sketch, std::vector<bool> const& is_faint,
                                           WorkSpace const& space, SimplifyOptions const& options,
                                           Progress const& progress,
                                           std::vector<GroupShapes>& groups) {
  std::vector<int> changed;
  if (groups.size() < 2) return changed;
  std::vector<std::vector<LayerArea>> areas;
  for (auto const& group : groups) {
    areas.emplace_back();
    for (auto const& layer : group.layers) areas.back().emplace_back(layer, space);
  }
  std::vector<std::optional<std::vector<Layer>>> results;
  for (int g = 0; g < std::ssize(groups); ++g) {
    std::vector<LayerArea const*> hosts;
    for (int other = 0; other < std::ssize(groups); ++other) {
      for (auto const& area : areas[other]) {
        if (other != g) hosts.push_back(&area);
      }
    }
    MouthCloser const closer(sketch, hosts, space, options, progress);
    auto layers = close_group(sketch, groups[g], areas[g], is_faint, space, closer);
    if (!layers) return layers.error();
    results.push_back(*std::move(layers));
  }
  for (int g = 0; g < std::ssize(groups); ++g) {
    if (!results[g]) continue;
    groups[g].layers = *std::move(results[g]);
    changed.push_back(g);
  }
  return changed;
}

}  // namespace inkflate
