// SPDX-License-Identifier: Apache-2.0
#include "ink/refine_line.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace inkflate {
namespace {

constexpr double kSpacingPx = 2.5;
/// Two passes of a mean over 2 * 2 + 1 points: enough against steps of one pixel, and a bow of 10 px radius shrinks
/// by a fifth of a pixel only.
constexpr int kSmoothReach = 2;
constexpr int kSmoothPasses = 2;
/// Directions across the line are taken from points this far along it.
constexpr int kDirectionReach = 4;
/// How far thinning may be from the middle.
constexpr double kLargestShiftPx = 1.5;
/// Beyond the pen's radius the ink must have faded, else another line lies there.
constexpr double kClearancePx = 2;
constexpr double kProfileStepPx = 0.5;
/// Points beyond the pen's radius that the end of a line may bend.
constexpr int kEndMargin = 2;

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

/// Index arithmetic on an open or closed list of points.
struct Indices {
  int count = 0;
  bool is_closed = false;

  int at(int i) const {
    return is_closed ? (i % count + count) % count : std::clamp(i, 0, count - 1);
  }
  /// How far both sides of i can be used alike: the ends of an open line stay in place.
  int reach(int i, int wanted) const {
    return is_closed ? std::min(wanted, (count - 1) / 2) : std::min({wanted, i, count - 1 - i});
  }
};

/// Means over the neighbours on both sides, several times.
template <typename T>
void smooth(std::vector<T>& values, Indices const& indices) {
  for (int pass = 0; pass < kSmoothPasses; ++pass) {
    auto const before = values;
    for (int i = 0; i < indices.count; ++i) {
      int const reach = indices.reach(i, kSmoothReach);
      T sum{};
      for (int k = i - reach; k <= i + reach; ++k) sum += before[slot(indices.at(k))];
      values[slot(i)] = sum * (1.0 / (2 * reach + 1));
    }
  }
}

/// Between the four nearest pixel centres; the border goes on outside.
double strength_at(Mask const& strength, Vec2 p) {
  double const x = std::clamp(p.x - 0.5, 0.0, strength.width - 1.0);
  double const y = std::clamp(p.y - 0.5, 0.0, strength.height - 1.0);
  int const x0 = static_cast<int>(x);
  int const y0 = static_cast<int>(y);
  int const x1 = std::min(x0 + 1, strength.width - 1);
  int const y1 = std::min(y0 + 1, strength.height - 1);
  double const top = strength.at(x0, y0) + (x - x0) * (strength.at(x1, y0) - strength.at(x0, y0));
  double const low = strength.at(x0, y1) + (x - x0) * (strength.at(x1, y1) - strength.at(x0, y1));
  return top + (y - y0) * (low - top);
}

/// The ink on a short line across a stroke.
struct Profile {
  double shift_px = 0;  // of its middle
  double width_px = 0;  // of a line of full strength with as much ink
  bool is_clear = false;
};

Profile profile_across(Mask const& strength, Vec2 p, Vec2 across, double radius_px) {
  int const steps = static_cast<int>((radius_px + kClearancePx) / kProfileStepPx + 1);
  double sum = 0;
  double moment = 0;
  double most = 0;
  double rim = 0;
  for (int i = -steps; i <= steps; ++i) {
    double const offset_px = i * kProfileStepPx;
    double const value = strength_at(strength, p + offset_px * across);
    sum += value;
    moment += value * offset_px;
    most = std::max(most, value);
    if (i == -steps || i == steps) rim = std::max(rim, value);
  }
  if (most <= 0) return {};
  return {moment / sum, sum * kProfileStepPx / most, rim < 0.3 * most};
}

double radius_at(Grid2<double> const& radius_px, Vec2 p) {
  int const x = std::clamp(static_cast<int>(p.x), 0, radius_px.width - 1);
  int const y = std::clamp(static_cast<int>(p.y), 0, radius_px.height - 1);
  return radius_px.at(x, y);
}

/// Moves the points to the middle of the ink; gives the width.
double centre_points(std::vector<Vec2>& points, Indices const& indices, Mask const& strength,
                     Grid2<double> const& radius_px) {
  std::vector<double> shifts(points.size());
  std::vector<Vec2> normals(points.size());
  double clear_width_px = 0;
  int clear_count = 0;
  double radius_sum_px = 0;
  for (int i = 0; i < indices.count; ++i) {
    Vec2 const p = points[slot(i)];
    double const radius = std::max(0.5, radius_at(radius_px, p));
    radius_sum_px += radius;
    Vec2 const along = points[slot(indices.at(i + kDirectionReach))] -
                       points[slot(indices.at(i - kDirectionReach))];
    normals[slot(i)] = perpendicular(normalized(along));
    auto const profile = profile_across(strength, p, normals[slot(i)], radius);
    if (!profile.is_clear) continue;
    shifts[slot(i)] = std::clamp(profile.shift_px, -kLargestShiftPx, kLargestShiftPx);
    clear_width_px += profile.width_px;
    ++clear_count;
  }
  smooth(shifts, indices);
  for (int i = 0; i < indices.count; ++i) points[slot(i)] += shifts[slot(i)] * normals[slot(i)];
  // Where other lines are near all along, the distance to the paper must do.
  if (4 * clear_count < indices.count) return 2 * radius_sum_px / indices.count;
  return clear_width_px / clear_count;
}

/// Thinning bends the last bit of a line towards a corner of its end: there it goes straight on instead.
void straighten_ends(std::vector<Vec2>& points, double radius_px) {
  auto const count = static_cast<int>(points.size());
  int const bent = std::min(static_cast<int>(radius_px) + kEndMargin, count / 3);
  int const far = std::min(bent + 2 * kDirectionReach, count - 1);
  for (int side = 0; side < 2; ++side) {
    double const left_px = length(std::span(points).first(slot(bent) + 1));
    Vec2 const along = normalized(points[slot(bent)] - points[slot(far)]);
    for (int i = 0; i < bent; ++i) {
      points[slot(i)] = points[slot(bent)] + left_px * (bent - i) / bent * along;
    }
    std::reverse(points.begin(), points.end());
  }
}

/// Points at equal distances; both ends stay.
Polyline resampled(Polyline const& points) {
  double const total_px = length(points);
  int const count = std::max(1, static_cast<int>(std::round(total_px / kSpacingPx)));
  Polyline result = {points.front()};
  double done_px = 0;
  std::size_t i = 1;
  for (int k = 1; k < count; ++k) {
    double const wanted_px = total_px * k / count;
    double step_px = distance(points[i - 1], points[i]);
    while (done_px + step_px < wanted_px && i + 1 < points.size()) {
      done_px += step_px;
      ++i;
      step_px = distance(points[i - 1], points[i]);
    }
    double const t = step_px > 0 ? std::min(1.0, (wanted_px - done_px) / step_px) : 0;
    result.push_back(lerp(points[i - 1], points[i], t));
  }
  result.push_back(points.back());
  return result;
}

}  // namespace

RefinedLine refine_line(JoinedLine const& line, Mask const& strength,
                        Grid2<double> const& radius_px) {
  RefinedLine result;
  auto points = line.points;
  if (points.size() < 2) {
    result.points = points;
    result.width_px = 2 * std::max(0.5, radius_at(radius_px, points[0]));
    return result;
  }
  Indices const indices = {static_cast<int>(points.size()), line.is_closed};
  smooth(points, indices);
  result.width_px = centre_points(points, indices, strength, radius_px);
  smooth(points, indices);
  if (line.is_closed) {
    points.push_back(points.front());
  } else {
    straighten_ends(points, result.width_px / 2);
  }
  result.points = resampled(points);
  return result;
}

}  // namespace inkflate
