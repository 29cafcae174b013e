// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec2.h"

namespace inkflate {

/// Directions as complex numbers x + y i: (cos t, sin t) turns by t, from x towards y.

/// a, turned by the angle of b and as many times as long as b.
inline Vec2 product(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
/// Turns the other way, by as much.
inline Vec2 conjugate(Vec2 a) { return {a.x, -a.y}; }

}  // namespace inkflate
