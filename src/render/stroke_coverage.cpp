// SPDX-License-Identifier: Apache-2.0
#include "render/stroke_coverage.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

struct Interval {
  double low = 0;
  double high = 0;
};

/// Where the part of the segment with |y - row_y| <= reach lies in x; its ends may be in the wrong order only
/// when there is no such part.
Interval x_near_row(Vec2 a, Vec2 b, double row_y, double reach) {
  double low = 0;
  double high = 1;
  double const dy = b.y - a.y;
  if (dy != 0) {
    double const t0 = (row_y - reach - a.y) / dy;
    double const t1 = (row_y + reach - a.y) / dy;
    low = std::clamp(std::min(t0, t1), 0.0, 1.0);
    high = std::clamp(std::max(t0, t1), 0.0, 1.0);
  }
  double const x0 = a.x + low * (b.x - a.x);
  double const x1 = a.x + high * (b.x - a.x);
  return {std::min(x0, x1), std::max(x0, x1)};
}

int clamped_index(double value, int count) {
  return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(count)));
}

/// The overlap of a pixel, 1 px wide at this distance from the centre line, with a band of the given radius.
double band_share(double distance_px, double radius_px) {
  double const overlap =
      std::min(distance_px + 0.5, radius_px) - std::max(distance_px - 0.5, -radius_px);
  return std::clamp(overlap, 0.0, 1.0);
}

}  // namespace

StrokeCoverage::StrokeCoverage(int width, int height) : shares_(width, height) {}

void StrokeCoverage::add_segment(Vec2 a, double width_a_px, Vec2 b, double width_b_px) {
  double const reach = std::max(width_a_px, width_b_px) / 2 + 0.5;
  Vec2 const along = b - a;
  double const squared_length = squared_norm(along);
  int const first_row = clamped_index(std::min(a.y, b.y) - reach, shares_.height);
  int const end_row = clamped_index(std::max(a.y, b.y) + reach + 1, shares_.height);
  for (int y = first_row; y < end_row; ++y) {
    auto const span = x_near_row(a, b, y + 0.5, reach);
    int const first = clamped_index(span.low - reach, shares_.width);
    int const end = clamped_index(span.high + reach + 1, shares_.width);
    for (int x = first; x < end; ++x) {
      Vec2 const p = {x + 0.5, y + 0.5};
      double const t =
          squared_length > 0 ? std::clamp(dot(p - a, along) / squared_length, 0.0, 1.0) : 0;
      double const radius_px = (width_a_px + t * (width_b_px - width_a_px)) / 2;
      auto const share = static_cast<float>(band_share(distance(p, a + t * along), radius_px));
      auto& seen = shares_.at(x, y);
      if (share <= seen) continue;
      if (seen == 0) touched_.push_back(y * shares_.width + x);
      seen = share;
    }
  }
}

}  // namespace inkflate
