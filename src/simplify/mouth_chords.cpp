// SPDX-License-Identifier: Apache-2.0
#include "simplify/mouth_chords.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

// A limb that ends no farther than this from another part's outline is meant to join it, work px.
constexpr double kShortOfPx = 12;

// Of the way along a chord lies over the host.
constexpr double kOverShare = 0.8;

// No narrower than a line, work px.
constexpr double kLeastChordPx = 7;

// Of the way along a chord lies within the limb as it is.
constexpr double kMostOwnShare = 0.3;

// Of a chord's length: the two strokes' last stretches beyond what the limb encloses already. Half of what the sides must have in the end, for the
// stretches may go on in other strokes.
constexpr double kLeastSides = 0.2;

// Nearer to the limb's outline than this is no stretch beyond it; a longer stretch is long enough, work px.
constexpr double kSameLinePx = 8;
constexpr double kLongStretchPx = 100;

// A limb has two or three loose ends at its mouth; these bound the work for others.
constexpr int kMostEnds = 12;
constexpr int kMostChords = 12;

// A chord is looked at every so many work px.
constexpr double kStepPx = 5;

bool is_over(Chord const& chord, LayerArea const& host, LayerArea const* own) {
  int const steps =
      std::max(2, 2 * static_cast<int>(distance(chord.from, chord.to) / (2 * kStepPx)));
  int over = 0;
  int within = 0;
  for (int k = 1; k < steps; ++k) {
    auto const p = lerp(chord.from, chord.to, static_cast<double>(k) / steps);
    bool const is_covered = host.covers(p, kShortOfPx);
    if (!is_covered && 2 * k == steps) return false;
    over += is_covered ? 1 : 0;
    within += own != nullptr && own->holds(p) ? 1 : 0;
  }
  return over >= kOverShare * (steps - 1) && within <= kMostOwnShare * (steps - 1);
}

/// How far the end's stroke runs beyond the limb.
double stretch_px(LooseEnd const& end, std::vector<StrokeSample> const& points,
                  LayerArea const* own) {
  double sum = 0;
  int at = end.sample;
  while (sum < kLongStretchPx && own != nullptr) {
    int const next = at + end.back;
    bool const is_end =
        next < 0 || next >= std::ssize(points) || points[next].stroke != points[at].stroke;
    if (is_end || own->covers(points[next].position, kSameLinePx)) return sum;
    sum += distance(points[at].position, points[next].position);
    at = next;
  }
  return own == nullptr ? end.length_px : sum;
}

struct RankedChord {
  MouthChord mouth;
  double sides_per_px;
};

bool is_known(std::vector<RankedChord> const& chords, int end_a, int end_b) {
  return std::any_of(chords.begin(), chords.end(), [&](RankedChord const& known) {
    return known.mouth.end_a == end_a && known.mouth.end_b == end_b;
  });
}

/// The ends that may belong to a mouth into this host, in their order.
std::vector<int> ends_at(LayerArea const& host, StrokeSamples const& samples,
                         std::vector<LooseEnd> const& ends, LayerArea const* own) {
  std::vector<int> found;
  for (int i = 0; i < std::ssize(ends); ++i) {
    auto const p = samples.points[ends[i].sample].position;
    if (!host.covers(p, kShortOfPx)) continue;
    if (own != nullptr && own->holds(p) && !own->is_at_rim(p, kShortOfPx)) continue;
    found.push_back(i);
  }
  if (std::ssize(found) <= kMostEnds) return found;
  std::stable_sort(found.begin(), found.end(),
                   [&](int a, int b) { return ends[a].length_px > ends[b].length_px; });
  found.resize(kMostEnds);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<MouthChord> mouth_chords(StrokeSamples const& samples,
                                     std::vector<LooseEnd> const& ends,
                                     std::span<LayerArea const* const> hosts, LayerArea const* own,
                                     double longest_px) {
  std::vector<RankedChord> found;
  for (auto const* host : hosts) {
    auto const at_host = ends_at(*host, samples, ends, own);
    std::vector<double> stretches;
    for (int const end : at_host)
      stretches.push_back(at_host.size() > 1 ? stretch_px(ends[end], samples.points, own) : 0);
    for (std::size_t i = 0; i < at_host.size(); ++i) {
      for (std::size_t j = i + 1; j < at_host.size(); ++j) {
        int const a = at_host[i];
        int const b = at_host[j];
        Chord const chord = {samples.points[ends[a].sample].position,
                             samples.points[ends[b].sample].position};
        double const size = distance(chord.from, chord.to);
        double const sides = stretches[i] + stretches[j];
        if (size < kLeastChordPx || size > longest_px || sides < kLeastSides * size) continue;
        if (!is_known(found, a, b) && is_over(chord, *host, own))
          found.push_back({{chord, a, b}, sides / size});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](RankedChord const& x, RankedChord const& y) {
    return x.sides_per_px > y.sides_per_px;
  });
  std::vector<MouthChord> chords;
  for (auto const& ranked : found) {
    if (std::ssize(chords) < kMostChords) chords.push_back(ranked.mouth);
  }
  return chords;
}

}  // namespace inkflate
