// SPDX-License-Identifier: Apache-2.0
#include "simplify/prune_whiskers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/crossings.h"
#include "geometry/point_grid.h"

namespace inkflate {
namespace {

// A pair of corners counts as the two sides of a whisker only when the walk between them is longer than this many widths:
// neighbours along the rim are always near each other.
constexpr double kLeastWalk = 2.5;

// The tip and the knots of a whisker may be wider; together no more than this many widths of walk.
constexpr double kMostThick = 5;

// Crossing cuts are taken back in rounds of this many.
constexpr int kMostCrossings = 100;

/// The rim from one corner forward to another.
struct Stretch {
  int from;
  int to;
  double walk_px;
};

class WhiskerFinder {
 public:
  WhiskerFinder(Contour const& points, double width_px)
      : points_(points),
        width_(width_px),
        count_(static_cast<int>(std::ssize(points))),
        grid_(points, width_px) {
    walk_.assign(points.size() + 1, 0);
    for (int i = 0; i < count_; ++i) {
      walk_[i + 1] = walk_[i] + distance(points_[i], points_[(i + 1) % count_]);
    }
    find_opposite_sides();
  }

  std::vector<Stretch> find() const {
    std::vector<Stretch> found;
    for (int i = 0; i < count_; ++i) {
      Stretch best = {i, i, 0};
      for (int k = pair_starts_[i]; k < pair_starts_[i + 1]; ++k) {
        int const j = pairs_[k];
        double const walk = forward(walk_, i, j);
        if (walk <= best.walk_px || walk > walk_[count_] / 2) continue;
        if (forward(thick_, i, j) <= kMostThick * width_) best = {i, j, walk};
      }
      if (best.walk_px > 0) found.push_back(best);
    }
    return found;
  }

  /// The length of the rim that has no other side near.
  double thick_length() const { return thick_[count_]; }

 private:
  double forward(std::vector<double> const& sums, int i, int j) const {
    return j >= i ? sums[j] - sums[i] : sums[count_] - sums[i] + sums[j];
  }

  Vec2 tangent(int i) const {
    return normalized(points_[(i + 1) % count_] - points_[(i + count_ - 1) % count_]);
  }

  /// The other side of i: near, across the inside, running the other way.
  bool is_opposite(int i, int j, Vec2 tangent_i, Vec2 tangent_j) const {
    auto const across = points_[j] - points_[i];
    if (squared_norm(across) > width_ * width_) return false;
    double const walk = forward(walk_, i, j);
    double const least = kLeastWalk * width_;
    if (walk < least || walk_[count_] - walk < least) return false;
    // The inside lies clockwise of the walk on the screen: outer rims have positive area with y down.
    return cross(tangent_i, across) >= 0 && dot(tangent_i, tangent_j) < 0;
  }

  void find_opposite_sides() {
    std::vector<Vec2> tangents(points_.size());
    for (int i = 0; i < count_; ++i) tangents[i] = tangent(i);
    thick_.assign(points_.size() + 1, 0);
    pair_starts_.assign(1, 0);
    for (int i = 0; i < count_; ++i) {
      grid_.near(points_[i], width_, [&](int j) {
        if (j != i && is_opposite(i, j, tangents[i], tangents[j])) pairs_.push_back(j);
      });
      bool const is_thin = static_cast<int>(std::ssize(pairs_)) > pair_starts_.back();
      pair_starts_.push_back(static_cast<int>(std::ssize(pairs_)));
      thick_[i + 1] = thick_[i] + (is_thin ? 0 : walk_[i + 1] - walk_[i]);
    }
  }

  Contour const& points_;
  double width_;
  int count_;
  PointGrid grid_;
  std::vector<double> walk_;   // prefix sums of edge lengths
  std::vector<double> thick_;  // the same, of the edges without an opposite side
  std::vector<int> pairs_;     // opposite sides, corner by corner
  std::vector<int> pair_starts_;
};

/// The corners that stay when the stretches are cut off, longest first; a stretch that overlaps an earlier one is dropped.
std::vector<int> kept_corners(std::vector<Stretch> stretches, int count) {
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](Stretch const& a, Stretch const& b) { return a.walk_px > b.walk_px; });
  std::vector<std::uint8_t> is_kept(static_cast<std::size_t>(count), 1);
  for (auto const& stretch : stretches) {
    if (is_kept[stretch.from] == 0 || is_kept[stretch.to] == 0) continue;
    for (int i = (stretch.from + 1) % count; i != stretch.to; i = (i + 1) % count) is_kept[i] = 0;
  }
  std::vector<int> kept;
  for (int i = 0; i < count; ++i) {
    if (is_kept[i] != 0) kept.push_back(i);
  }
  return kept;
}

/// Whether the rim between a kept corner and the next one was cut off.
bool is_cut(std::vector<int> const& kept, int k, int count) {
  return kept[(k + 1) % std::ssize(kept)] != (kept[k] + 1) % count;
}

/// The corners where cuts start that cross other edges: a foot may be jagged.
std::vector<int> crossing_cuts(Contour const& points, std::vector<int> const& kept) {
  Contour contour;
  contour.reserve(kept.size());
  for (int const i : kept) contour.push_back(points[i]);
  std::vector<int> found;
  for (auto const& crossing : find_crossings(std::span(&contour, 1), kMostCrossings)) {
    for (int const edge : {crossing.edge_a, crossing.edge_b}) {
      if (is_cut(kept, edge, static_cast<int>(std::ssize(points)))) found.push_back(kept[edge]);
    }
  }
  return found;
}

}  // namespace

Rim prune_whiskers(Rim const& rim, StrokeSamples const& samples, double width_px) {
  auto const points = positions(rim, samples);
  WhiskerFinder const finder(points, width_px);
  // Nothing but whisker: all its sides are near each other.
  if (finder.thick_length() <= kMostThick * width_px) return {};
  int const count = static_cast<int>(std::ssize(rim));
  auto stretches = finder.find();
  auto kept = kept_corners(stretches, count);
  for (auto bad = crossing_cuts(points, kept); !bad.empty(); bad = crossing_cuts(points, kept)) {
    std::erase_if(stretches, [&](Stretch const& stretch) {
      return std::find(bad.begin(), bad.end(), stretch.from) != bad.end();
    });
    kept = kept_corners(stretches, count);
  }
  if (kept.size() < 3) return {};
  Rim result;
  for (int k = 0; k < std::ssize(kept); ++k) {
    result.push_back(rim[kept[k]]);
    if (is_cut(kept, k, count)) result.back().to_next = RunKind::Ink;
  }
  return result;
}

}  // namespace inkflate
