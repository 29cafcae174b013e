// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/vec2.h"

namespace inkflate {

/// A cubic Bezier curve by its four control points, px.
struct Cubic {
  std::array<Vec2, 4> control;

  friend bool operator==(Cubic const&, Cubic const&) = default;

  Vec2 start() const { return control[0]; }
  Vec2 end() const { return control[3]; }
};

/// The straight curve from one point to another, at constant speed.
Cubic line_cubic(Vec2 from, Vec2 to);

/// The cubic that is the same curve as a quadratic Bezier.
Cubic quadratic_cubic(Vec2 from, Vec2 control, Vec2 to);

/// The point at t in [0, 1]. By de Casteljau; exact at both ends.
Vec2 point_at(Cubic const& curve, double t);

/// The derivative by t; zero where control points coincide.
Vec2 derivative_at(Cubic const& curve, double t);

struct CubicHalves {
  Cubic first;
  Cubic second;
};
CubicHalves split(Cubic const& curve, double t);

/// Number of equal steps in t so that the chords stay within tolerance of the curve:
/// n = sqrt(3/4 max|second difference| / tolerance), at least 1 and at most 4096.
/// source  Wang's bound on the second derivative (Sederberg, CAGD notes, section 10.6)
int flatten_count(Cubic const& curve, double tolerance_px);

/// Appends the points of the curve after its start; the last one is exactly its end.
void flatten_into(Cubic const& curve, double tolerance_px, std::vector<Vec2>& points);

}  // namespace inkflate
