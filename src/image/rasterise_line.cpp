// SPDX-License-Identifier: Apache-2.0
#include "image/rasterise_line.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

constexpr double kFarthestPx = 1e6;

/// One coordinate of a line that takes a pixel per step along its longer side.
struct Axis {
  std::int64_t start = 0;
  std::int64_t distance = 0;  // >= 0
  std::int64_t sign = 1;

  Axis(double from, double to)
      : start(static_cast<std::int64_t>(std::floor(from))),
        distance(static_cast<std::int64_t>(std::floor(to)) - start),
        sign(distance < 0 ? -1 : 1) {
    distance *= sign;
  }
};

bool is_near(Vec2 p) {
  return std::fabs(p.x) <= kFarthestPx && std::fabs(p.y) <= kFarthestPx;  // false for NaN
}

}  // namespace

void rasterise_line(Vec2 from, Vec2 to, Mask& mask, std::uint8_t value) {
  CHECK(is_near(from) && is_near(to), "points must be within 1e6 px");
  Axis const x(from.x, to.x);
  Axis const y(from.y, to.y);
  bool const is_flat = x.distance >= y.distance;
  Axis const& major = is_flat ? x : y;
  Axis const& minor = is_flat ? y : x;
  std::int64_t const size = is_flat ? mask.width : mask.height;
  // The steps whose major coordinate is in the mask.
  std::int64_t const first =
      std::max<std::int64_t>(0, major.sign > 0 ? -major.start : major.start - (size - 1));
  std::int64_t const last =
      std::min(major.distance, major.sign > 0 ? size - 1 - major.start : major.start);
  if (first > last) return;
  // After step k the minor coordinate has moved by k * minor / major, rounded; the error is the remainder.
  std::int64_t const whole = std::max<std::int64_t>(1, 2 * major.distance);
  std::int64_t const scaled = 2 * minor.distance * first + major.distance;
  std::int64_t moved = scaled / whole;
  std::int64_t error = scaled % whole;
  for (std::int64_t step = first; step <= last; ++step) {
    auto const along = static_cast<int>(major.start + major.sign * step);
    auto const across = static_cast<int>(minor.start + minor.sign * moved);
    int const column = is_flat ? along : across;
    int const row = is_flat ? across : along;
    if (mask.contains(column, row)) mask.at(column, row) = value;
    error += 2 * minor.distance;
    if (error >= whole) {
      error -= whole;
      ++moved;
    }
  }
}

void rasterise_polyline(std::span<Vec2 const> points, Mask& mask, std::uint8_t value) {
  if (points.size() == 1) rasterise_line(points[0], points[0], mask, value);
  for (std::size_t i = 1; i < points.size(); ++i) {
    rasterise_line(points[i - 1], points[i], mask, value);
  }
}

}  // namespace inkflate
