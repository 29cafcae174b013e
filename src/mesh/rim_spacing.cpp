// SPDX-License-Identifier: Apache-2.0
#include "mesh/rim_spacing.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "mesh/circumcentre.h"
#include "mesh/region_triangulation.h"

namespace inkflate {
namespace {

// How fast the width may shrink towards a corner, px per px. At a tip of 53 degrees or sharper it truly shrinks that slowly; at
// blunter corners and at the rim's jitter the touching circle vanishes although the region is not thin.
constexpr double kCornerSlope = 1;

// Each takes what is fine along the rim and across the region once more; what is left after these is below what can be seen.
constexpr int kMostRounds = 4;

/// One value per point of all contours, side by side.
class RimValues {
 public:
  RimValues(std::span<Contour const> contours, double value) : contours_(contours) {
    std::size_t count = 0;
    for (auto const& contour : contours) count += contour.size();
    values.assign(count, value);
  }

  /// values[i] = pick(values[i], values[j], distance) for neighbours i and j along the rim, all the way round in both directions.
  template <typename Pick>
  void sweep(Pick pick) {
    int first = 0;
    for (auto const& contour : contours_) {
      int const count = static_cast<int>(contour.size());
      auto const step = [&](int from, int to) {
        auto& value = values[first + to];
        value = pick(value, values[first + from], distance(contour[from], contour[to]));
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

 private:
  std::span<Contour const> contours_;
};

/// The widest empty circle at each point: the Delaunay triangles at it know all circles that touch the rim there.
void measure_widths(RegionTriangulation const& region, std::vector<double>& widths) {
  auto const& triangles = region.triangles;
  for (int t = 0; t < triangles.triangle_count(); ++t) {
    if (region.is_inside[t] == 0) continue;
    int const e = 3 * t;
    auto const a = triangles.start(e);
    double const width =
        2 * distance(a, circumcentre(a, triangles.start(e + 1), triangles.start(e + 2)));
    for (int i = 0; i < 3; ++i) {
      auto& at_corner = widths[triangles.corner(e + i)];
      if (width > at_corner) at_corner = width;
    }
  }
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

// Of one line; more would be a mistake in the spacing.
constexpr double kMostEdges = 1e6;

/// How far along a piece of a line, 0 .. 1, the given amount is reached when the density goes evenly from start to end.
double share_reached(double amount, double length_px, double start, double end) {
  double const root = start * start + 2 * (end - start) * amount / length_px;
  double const share = 2 * amount / (start + std::sqrt(std::max(0.0, root))) / length_px;
  return share < 1 ? share : 1;
}

}  // namespace

std::vector<std::vector<double>> rim_spacing(std::span<Contour const> contours,
                                             RimSpacingOptions const& options) {
  RimValues rim(contours, 0);
  auto const region = triangulate_region(contours);
  if (!region) {
    // No region: mesh_region says why.
    rim.values.assign(rim.values.size(), options.longest_px);
    return rim.by_contour();
  }
  measure_widths(*region, rim.values);
  rim.sweep([](double mine, double other, double step) {
    return std::max(mine, other - kCornerSlope * step);
  });
  for (auto& value : rim.values)
    value =
        std::max(options.shortest_px, std::min(options.longest_px, options.share_of_width * value));
  bool has_changed = true;
  for (int round = 0; round < kMostRounds && has_changed; ++round) {
    rim.sweep([&](double mine, double other, double step) {
      return std::min(mine, other + options.growth * step);
    });
    has_changed = limit_across(*region, options.growth, rim.values);
  }
  return rim.by_contour();
}

Polyline resample(std::span<Vec2 const> line, std::span<double const> spacing) {
  CHECK(line.size() >= 2 && line.size() == spacing.size(), "a line has a spacing at each point");
  std::vector<double> amounts = {0};  // edges up to each point
  for (std::size_t i = 1; i < line.size(); ++i) {
    double const density = (1 / spacing[i - 1] + 1 / spacing[i]) / 2;
    amounts.push_back(amounts.back() + distance(line[i - 1], line[i]) * density);
  }
  double const total = amounts.back();
  double const least = line.front() == line.back() ? 3 : 1;
  double const edges = std::max(least, std::min(kMostEdges, std::floor(total + 0.5)));
  Polyline result = {line.front()};
  std::size_t piece = 1;
  for (double k = 1; k < edges; ++k) {
    double const wanted = total * k / edges;
    while (piece + 1 < line.size() && amounts[piece] < wanted) ++piece;
    double const share =
        share_reached(wanted - amounts[piece - 1], distance(line[piece - 1], line[piece]),
                      1 / spacing[piece - 1], 1 / spacing[piece]);
    result.push_back(lerp(line[piece - 1], line[piece], share));
  }
  result.push_back(line.back());
  return result;
}

}  // namespace inkflate
