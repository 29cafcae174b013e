// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec2.h"

namespace inkflate {

/// The centre of the circle through a, b and c; far away or not finite when they are almost on a line.
inline Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c) {
  auto const p = b - a;
  auto const q = c - a;
  double const pp = squared_norm(p);
  double const qq = squared_norm(q);
  return a + Vec2{q.y * pp - p.y * qq, p.x * qq - q.x * pp} / (2 * cross(p, q));
}

}  // namespace inkflate
