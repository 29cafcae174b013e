// SPDX-License-Identifier: Apache-2.0
#include "simplify/rim_chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace inkflate {
namespace {

// A run shorter than this says nothing of its own, frame px: about the width of a pencil line that was drawn three times.
constexpr double kLeastRun_px = 7;

// A corner is a turn of more than 50 degrees between chords of this length, frame px ...
constexpr double kChord_px = 14;
constexpr double kCornerCosine = 0.64;
// ... most of which happens within shorter chords: else it is a bend. A circle turns by half there.
constexpr double kShortChord_px = 7;
constexpr double kShortCosine = 0.80;

struct KindRun {
  int first;
  int size;
  RunKind kind;
  double length_px;
};

std::vector<KindRun> kind_runs(std::vector<RunKind> const& kinds, Contour const& positions) {
  int const count = static_cast<int>(std::ssize(kinds));
  int first = 0;
  while (first < count && kinds[first] == kinds[(first + count - 1) % count]) ++first;
  if (first == count) return {{0, count, kinds[0], perimeter(positions)}};
  std::vector<KindRun> runs;
  for (int k = 0; k < count; ++k) {
    int const i = (first + k) % count;
    if (runs.empty() || runs.back().kind != kinds[i]) runs.push_back({i, 0, kinds[i], 0});
    ++runs.back().size;
    runs.back().length_px += distance(positions[i], positions[(i + 1) % count]);
  }
  return runs;
}

/// Whether a short run stands for nothing, and for which kind it gives way.
RunKind effective_kind(std::vector<KindRun> const& runs, int r) {
  int const count = static_cast<int>(std::ssize(runs));
  auto const& run = runs[r];
  if (count == 1 || run.length_px >= kLeastRun_px) return run.kind;
  auto const before = runs[(r + count - 1) % count].kind;
  auto const after = runs[(r + 1) % count].kind;
  if (before == after) return before;
  return run.kind == RunKind::Closing ? RunKind::Ink : run.kind;
}

std::vector<RunKind> settled_kinds(Rim const& rim, Contour const& positions) {
  std::vector<RunKind> kinds;
  kinds.reserve(rim.size());
  for (auto const& point : rim) kinds.push_back(point.to_next);
  int const count = static_cast<int>(std::ssize(kinds));
  // First gaps within the pencil's width, for the two sides of such a gap may be short as well.
  for (auto const shortest_first : {RunKind::Closing, RunKind::HelpLine, RunKind::Ink}) {
    auto const runs = kind_runs(kinds, positions);
    for (int r = 0; r < std::ssize(runs); ++r) {
      if (runs[r].kind != shortest_first) continue;
      auto const kind = effective_kind(runs, r);
      for (int k = 0; k < runs[r].size; ++k) kinds[(runs[r].first + k) % count] = kind;
    }
  }
  return kinds;
}

/// Walks along a closed polyline by arc length.
class ArcWalk {
 public:
  explicit ArcWalk(Contour const& points)
      : points_(points), count_(static_cast<int>(std::ssize(points))) {
    sums_.assign(points.size() + 1, 0);
    for (int i = 0; i < count_; ++i) {
      sums_[i + 1] = sums_[i] + distance(points[i], points[(i + 1) % count_]);
    }
  }

  double total() const { return sums_[count_]; }
  double at(int i) const { return sums_[i]; }

  /// The point at an arc length, which may run past either end of the list.
  Vec2 point(double s) const {
    s -= std::floor(s / total()) * total();
    auto const next = std::upper_bound(sums_.begin(), sums_.end(), s);
    int const i = std::clamp(static_cast<int>(next - sums_.begin()) - 1, 0, count_ - 1);
    double const size = sums_[i + 1] - sums_[i];
    return lerp(points_[i], points_[(i + 1) % count_],
                size > 0 ? std::min(1.0, (s - sums_[i]) / size) : 0);
  }

 private:
  Contour const& points_;
  int count_;
  std::vector<double> sums_;
};

/// The cosine of the turn at corner i between the chords of a length on both sides.
double turn_cosine(ArcWalk const& walk, Contour const& positions, int i, double chord_px) {
  auto const in = positions[i] - walk.point(walk.at(i) - chord_px);
  auto const out = walk.point(walk.at(i) + chord_px) - positions[i];
  double const size = norm(in) * norm(out);
  return size > 0 ? dot(in, out) / size : 1;
}

/// The sharpest place of every stretch of the rim that turns like a corner.
std::vector<std::uint8_t> find_corners(Contour const& positions) {
  int const count = static_cast<int>(std::ssize(positions));
  ArcWalk const walk(positions);
  std::vector<double> cosines(positions.size(), 1);
  if (walk.total() > 4 * kChord_px) {
    for (int i = 0; i < count; ++i) cosines[i] = turn_cosine(walk, positions, i, kChord_px);
  }
  std::vector<std::uint8_t> is_corner(positions.size(), 0);
  for (int i = 0; i < count; ++i) {
    if (cosines[i] > kCornerCosine) continue;
    bool is_sharpest = true;
    for (int const side : {-1, 1}) {
      double passed = 0;
      for (int k = i; is_sharpest;) {
        int const next = (k + side + count) % count;
        passed += distance(positions[k], positions[next]);
        k = next;
        if (passed > kChord_px || k == i) break;
        is_sharpest = cosines[i] < cosines[k] || (cosines[i] == cosines[k] && i < k);
      }
    }
    if (is_sharpest && turn_cosine(walk, positions, i, kShortChord_px) < kShortCosine)
      is_corner[i] = 1;
  }
  return is_corner;
}

}  // namespace

std::vector<RimChain> cut_rim(Rim const& rim, Contour const& positions) {
  int const count = static_cast<int>(std::ssize(rim));
  auto const kinds = settled_kinds(rim, positions);
  auto const is_corner = find_corners(positions);
  auto const is_break = [&](int i) {
    return is_corner[i] != 0 || kinds[i] != kinds[(i + count - 1) % count];
  };
  int first = 0;
  while (first < count && !is_break(first)) ++first;
  if (first == count) return {{0, count, kinds[0], true}};
  std::vector<RimChain> chains;
  for (int k = 0; k < count; ++k) {
    int const i = (first + k) % count;
    if (is_break(i)) chains.push_back({i, 0, kinds[i], false});
    ++chains.back().size;
  }
  return chains;
}

}  // namespace inkflate
