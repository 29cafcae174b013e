// SPDX-License-Identifier: Apache-2.0
#include "solidify/solid.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

// Two families may disagree by rounding about a node that lies on the surface.
constexpr double kRounding = 1e-6;

/// The part of a step that lies in a ball, as shares of the step; empty (first > last) if none.
std::array<double, 2> share_in_ball(Ball const& ball, Vec3 from, Vec3 step) {
  double const length = squared_norm(step);
  double const middle = dot(ball.centre - from, step) / length;
  double const off = squared_norm(from + step * middle - ball.centre);
  double const left = ball.radius * ball.radius - off;
  if (left < 0) return {1, 0};
  double const half = std::sqrt(left / length);
  return {middle - half, middle + half};
}

}  // namespace

Reach Solid::reach(LatticeNode from, int direction) const {
  auto const& family = families[family_of(direction)];
  auto const crossings = family.crossings(family.line(from));
  double const start = family.position(from);
  double const size = direction < kLongDirections ? 2 : 1;
  double const scale = is_forward(direction) ? 1 / size : -1 / size;
  LatticeNode const to = from + kSteps[direction];
  std::array<int, 2> touching = {-1, -1};
  if (!balls.empty())
    touching = {ball_of_node[lattice.index(from)], ball_of_node[lattice.index(to)]};
  double reached = 0;
  bool is_of_ball = false;
  for (double before = -1; reached > before && reached < 1;) {
    before = reached;
    auto const extend = [&](double a, double b, bool is_by_ball) {
      if (std::min(a, b) > reached + kRounding || std::max(a, b) <= reached) return;
      reached = std::max(a, b);
      is_of_ball = is_by_ball;
    };
    for (std::size_t c = 0; c + 1 < crossings.size(); c += 2)
      extend((crossings[c].at - start) * scale, (crossings[c + 1].at - start) * scale, false);
    for (int const b : touching) {
      if (b < 0) continue;
      auto const [first, last] =
          share_in_ball(balls[b], place_of(from), place_of(kSteps[direction]));
      if (first <= last && last > 0) extend(first, last, true);
    }
  }
  double const to_base = to.k < base ? (from.k - base) / (from.k - to.k) : 1;
  if (reached >= to_base) return {to_base, false};
  return {std::max(reached, 0.0), is_of_ball};
}

}  // namespace inkflate
