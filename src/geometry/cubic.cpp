// SPDX-License-Identifier: Apache-2.0
#include "geometry/cubic.h"

#include <algorithm>
#include <cmath>

namespace inkflate {

Cubic line_cubic(Vec2 from, Vec2 to) {
  return {{from, lerp(from, to, 1.0 / 3), lerp(from, to, 2.0 / 3), to}};
}

Cubic quadratic_cubic(Vec2 from, Vec2 control, Vec2 to) {
  return {{from, lerp(from, control, 2.0 / 3), lerp(to, control, 2.0 / 3), to}};
}

Vec2 point_at(Cubic const& curve, double t) { return split(curve, t).first.end(); }

Vec2 derivative_at(Cubic const& curve, double t) {
  auto const& p = curve.control;
  double const s = 1 - t;
  return 3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
}

CubicHalves split(Cubic const& curve, double t) {
  auto const& p = curve.control;
  if (t >= 1) return {curve, {{p[3], p[3], p[3], p[3]}}};
  auto const a = lerp(p[0], p[1], t);
  auto const b = lerp(p[1], p[2], t);
  auto const c = lerp(p[2], p[3], t);
  auto const ab = lerp(a, b, t);
  auto const bc = lerp(b, c, t);
  auto const middle = lerp(ab, bc, t);
  return {{{p[0], a, ab, middle}}, {{middle, bc, c, p[3]}}};
}

int flatten_count(Cubic const& curve, double tolerance_px) {
  auto const& p = curve.control;
  double const bend = std::max(norm(p[0] - 2 * p[1] + p[2]), norm(p[1] - 2 * p[2] + p[3]));
  double const steps = std::ceil(std::sqrt(0.75 * bend / tolerance_px));
  return static_cast<int>(std::clamp(steps, 1.0, 4096.0));
}

void flatten_into(Cubic const& curve, double tolerance_px, std::vector<Vec2>& points) {
  int const count = flatten_count(curve, tolerance_px);
  for (int i = 1; i < count; ++i) points.push_back(point_at(curve, static_cast<double>(i) / count));
  points.push_back(curve.end());
}

}  // namespace inkflate
