// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/vec2.h"

namespace inkflate {

/// The map p -> (a p.x + c p.y + e, b p.x + d p.y + f): SVG's matrix(a b c d e f).
struct Affine {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 1;
  double e = 0;
  double f = 0;

  friend bool operator==(Affine const&, Affine const&) = default;

  Vec2 operator()(Vec2 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  double determinant() const { return a * d - b * c; }
  /// The factor by which lengths grow on average: for stroke widths.
  double mean_scale() const { return std::sqrt(std::abs(determinant())); }

  static Affine translation(Vec2 t) { return {1, 0, 0, 1, t.x, t.y}; }
  static Affine scaling(double sx, double sy) { return {sx, 0, 0, sy, 0, 0}; }
};

/// First inner, then outer: (outer * inner)(p) == outer(inner(p)).
inline Affine operator*(Affine const& outer, Affine const& inner) {
  return {outer.a * inner.a + outer.c * inner.b,
          outer.b * inner.a + outer.d * inner.b,
          outer.a * inner.c + outer.c * inner.d,
          outer.b * inner.c + outer.d * inner.d,
          outer.a * inner.e + outer.c * inner.f + outer.e,
          outer.b * inner.e + outer.d * inner.f + outer.f};
}

}  // namespace inkflate
