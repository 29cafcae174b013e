// SPDX-License-Identifier: Apache-2.0
#include "mesh/rim_spacing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "mesh/circumcentre.h"
#include "mesh/region_triangulation.h"

namespace inkflate {
namespace {

// How fast the width may shrink towards a corner, px per px: the middle of a square's side is as wide as the square, its corners half
// of that.
constexpr double kCornerSlope = 1;

// A circle that touches the rim in places which are at most this many widths apart along the rim lies in a blunt corner or in the
// rim's jitter, where it is small although the region is not thin. In a square corner it is 1 width, in one of 60 degrees 1.7.
constexpr double kLocalReach = 1.5;

// Each takes what is fine along the rim and across the region once more; what is left after these is below what can be seen.
constexpr int kMostRounds = 4;

/// Where a point lies on the rim.
struct RimPlace {
  int contour;
  double along_px;
};

/// All points of all contours, side by side, with one value each.
class Rim {
 public:
  explicit Rim(std::span<Contour const> contours) : contours_(contours) {
    for (int c = 0; c < std::ssize(contours); ++c) {
      double along = 0;
      for (std::size_t i = 0; i < contours[c].size(); ++i) {
        if (i > 0) along += distance(contours[c][i - 1], contours[c][i]);
        places_.push_back({c, along});
      }
      perimeters_.push_back(perimeter(contours[c]));
    }
    values.assign(places_.size(), 0);
    is_local.assign(places_.size(), 1);
  }

  /// The shorter way along the rim; infinite between two contours.
  double way(int a, int b) const {
    auto const& from = places_[a];
    auto const& to = places_[b];
    if (from.contour != to.contour) return std::numeric_limits<double>::infinity();
    double const straight = std::abs(from.along_px - to.along_px);
    return std::min(straight, perimeters_[from.contour] - straight);
  }

  /// update(i, j, distance) for neighbours i and j along the rim, all the way round in both directions.
  template <typename Update>
  void sweep(Update update) {
    int first = 0;
    for (auto const& contour : contours_) {
      int const count = static_cast<int>(contour.size());
      auto const step = [&](int from, int to) {
        update(first + to, first + from, distance(contour[from], contour[to]));
      };
      for (int i = 0; i < 2 * count; ++i) step(i % count, (i + 1) % count);
      for (int i = 2 * count; i > 0; --i) step(i % count, (i - 1) % count);
      first += count;
    }
  }

  std::vector<std::vector<double>> by_contour() const {
    std::vector<std::vector<double>> result;
    auto next = values.begin();
    for (auto const& contour : contours_) {
      result.emplace_back(next, next + std::ssize(contour));
      next += std::ssize(contour);
    }
    return result;
  }

  std::vector<double> values;
  std::vector<std::uint8_t> is_local;  // whether the circle that gave the value is: see kLocalReach

 private:
  std::span<Contour const> contours_;
  std::vector<RimPlace> places_;
  std::vector<double> perimeters_;
};

/// The widest empty circle at each point: the Delaunay triangles at it know all circles that touch the rim there.
void measure_widths(RegionTriangulation const& region, Rim& rim) {
  auto const& triangles = region.triangles;
  for (int e = 0; e < 3 * triangles.triangle_count(); ++e) {
    if (region.is_inside[e / 3] == 0) continue;
    auto const a = triangles.start(e);
    int const v = triangles.corner(e);
    int const second = triangles.end_corner(e);
    int const third = triangles.apex(e);
    double const width =
        2 * distance(a, circumcentre(a, triangles.point(second), triangles.point(third)));
    if (!(width > rim.values[v])) continue;
    rim.values[v] = width;
    double const reach = std::max(rim.way(v, second), rim.way(v, third));
    rim.is_local[v] = reach <= kLocalReach * width ? 1 : 0;
  }
}

/// Where circles are only small because they are local, the width falls no faster than at a corner.
void fill_corners(Rim& rim) {
  rim.sweep([&](int i, int j, double step) {
    if (rim.is_local[i] != 0)
      rim.values[i] = std::max(rim.values[i], rim.values[j] - kCornerSlope * step);
  });
}

/// Across the region, along the triangles' edges. Whether anything changed.
bool limit_across(RegionTriangulation const& region, double growth, std::vector<double>& spacing) {
  bool has_changed = false;
  auto const& triangles = region.triangles;
  for (int e = 0; e < 3 * triangles.triangle_count(); ++e) {
    if (region.is_inside[e / 3] == 0) continue;
    int const a = triangles.corner(e);
    int const b = triangles.end_corner(e);
    double const step = growth * distance(triangles.point(a), triangles.point(b));
    if (spacing[a] > spacing[b] + step) {
      spacing[a] = spacing[b] + step;
      has_changed = true;
    } else if (spacing[b] > spacing[a] + step) {
      spacing[b] = spacing[a] + step;
      has_changed = true;
    }
  }
  return has_changed;
}

}  // namespace

std::vector<std::vector<double>> rim_spacing(std::span<Contour const> contours,
                                             RimSpacingOptions const& options) {
  Rim rim(contours);
  auto const region = triangulate_region(contours);
  if (!region) {
    // No region: mesh_region says why.
    rim.values.assign(rim.values.size(), options.longest_px);
    return rim.by_contour();
  }
  measure_widths(*region, rim);
  fill_corners(rim);
  for (auto& value : rim.values)
    value =
        std::max(options.shortest_px, std::min(options.longest_px, options.share_of_width * value));
  bool has_changed = true;
  for (int round = 0; round < kMostRounds && has_changed; ++round) {
    rim.sweep([&](int i, int j, double step) {
      rim.values[i] = std::min(rim.values[i], rim.values[j] + options.growth * step);
    });
    has_changed = limit_across(*region, options.growth, rim.values);
  }
  return rim.by_contour();
}

}  // namespace inkflate
