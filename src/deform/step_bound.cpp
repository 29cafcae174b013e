// SPDX-License-Identifier: Apache-2.0
#include "deform/step_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inkflate {
namespace {

/// The least positive root of c + b t + a t^2, c > 0. Neither form subtracts numbers of about the same size.
double least_root(double a, double b, double c) {
  constexpr double never = std::numeric_limits<double>::infinity();
  double const under_root = b * b - 4 * a * c;
  if (b < 0) return under_root >= 0 ? 2 * c / (std::sqrt(under_root) - b) : never;
  return a < 0 ? (b + std::sqrt(under_root)) / (-2 * a) : never;
}

}  // namespace

double step_bound(std::span<Triangle const> triangles, std::span<Vec2 const> pose,
                  std::span<Vec2 const> moves) {
  double bound = std::numeric_limits<double>::infinity();
  for (auto const& [i, j, k] : triangles) {
    Vec2 const u = pose[j] - pose[i];
    Vec2 const v = pose[k] - pose[i];
    Vec2 const du = moves[j] - moves[i];
    Vec2 const dv = moves[k] - moves[i];
    bound = std::min(bound, least_root(cross(du, dv), cross(u, dv) + cross(du, v), cross(u, v)));
  }
  return bound;
}

}  // namespace inkflate
