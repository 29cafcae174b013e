// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_hook.h"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/complex.h"
#include "geometry/segment.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

Vec2 mean(std::span<Vec2 const> points) {
  Vec2 sum;
  for (auto const p : points) sum += p;
  return sum / static_cast<double>(std::max<std::size_t>(points.size(), 1));
}

// A place so near to its anchor turns about it by nothing that anybody sees: inside of a mesh only rounding is beside.
constexpr double kBesidePx = 1e-9;

using Corners = std::array<Vec2, 3>;
using Weights = std::array<double, 3>;

Vec2 blend(Corners const& corners, Weights const& weights) {
  return corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
}

/// The weights of the triangle's nearest point to p.
Weights nearest_weights(Corners const& corners, Vec2 p) {
  auto const [a, b, c] = corners;
  double const area = cross(b - a, c - a);
  if (area != 0) {
    Weights const inside = {cross(c - b, p - b) / area, cross(a - c, p - c) / area,
                            cross(b - a, p - a) / area};
    if (std::min({inside[0], inside[1], inside[2]}) >= 0) return inside;
  }
  Weights best = {1, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t const next = (k + 1) % 3;
    double const t = share_along(p, corners[k], corners[next]);
    Weights weights = {0, 0, 0};
    weights[k] = 1 - t;
    weights[next] = t;
    double const far = squared_norm(blend(corners, weights) - p);
    if (far >= least) continue;
    least = far;
    best = weights;
  }
  return best;
}

/// No place of the triangle is nearer to p than this, squared.
double least_away(Corners const& corners, Vec2 p) {
  auto const [a, b, c] = corners;
  double const x =
      std::max({std::min({a.x, b.x, c.x}) - p.x, p.x - std::max({a.x, b.x, c.x}), 0.0});
  double const y =
      std::max({std::min({a.y, b.y, c.y}) - p.y, p.y - std::max({a.y, b.y, c.y}), 0.0});
  return x * x + y * y;
}

Corners corners_of(Triangle const& triangle, std::span<Vec2 const> pose) {
  return {pose[triangle[0]], pose[triangle[1]], pose[triangle[2]]};
}

}  // namespace

Vec2 RigidMotion::operator()(Vec2 p) const {
  if (cos == 1 && sin == 0) return p + (to - from);
  return to + product(p - from, {cos, sin});
}

RigidMotion best_motion(std::span<Vec2 const> points, std::span<Vec2 const> targets) {
  RigidMotion motion = {1, 0, mean(points), mean(targets)};
  double along = 0;
  double aside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    along += dot(points[i] - motion.from, targets[i] - motion.to);
    aside += cross(points[i] - motion.from, targets[i] - motion.to);
  }
  double const length = norm(Vec2{along, aside});
  if (length > 0) {
    motion.cos = along / length;
    motion.sin = aside / length;
  }
  return motion;
}

double turn_at(BendMesh const& mesh, BendPose const& pose, BendAnchor const& at) {
  auto const& triangle = mesh.rest.triangles[at.triangle];
  auto const rest = corners_of(triangle, mesh.rest.points);
  auto const now = corners_of(triangle, pose);
  auto const motion = best_motion(rest, now);
  return atan2_of(motion.sin, motion.cos);
}

BendHook hook_at(BendMesh const& mesh, BendPose const& pose, Vec2 place) {
  BendHook hook;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < std::ssize(mesh.rest.triangles); ++t) {
    auto const corners = corners_of(mesh.rest.triangles[t], pose);
    if (least_away(corners, place) >= least) continue;
    auto const weights = nearest_weights(corners, place);
    double const far = squared_norm(blend(corners, weights) - place);
    if (far >= least) continue;
    least = far;
    hook.anchor = {t, weights};
  }
  auto const turn = sin_cos(turn_at(mesh, pose, hook.anchor));
  auto const beside = place - place_of(mesh.rest, pose, hook.anchor);
  hook.beside = product(beside, {turn.cos, -turn.sin});
  return hook;
}

Vec2 place_of(BendMesh const& mesh, BendPose const& pose, BendHook const& hook) {
  auto const at = place_of(mesh.rest, pose, hook.anchor);
  if (norm(hook.beside) < kBesidePx) return at + hook.beside;
  auto const turn = sin_cos(turn_at(mesh, pose, hook.anchor));
  return at + product(hook.beside, {turn.cos, turn.sin});
}

}  // namespace inkflate
