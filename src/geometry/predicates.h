// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec2.h"

namespace inkflate {

/// On which side of the line a b the point c lies: 1 when a b c has positive area, -1 when negative, 0 exactly on it. Exact for all
/// finite input whose products neither overflow nor underflow.
/// source  Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic": the error bound; Dekker 1971: the exact product
int orientation_sign(Vec2 a, Vec2 b, Vec2 c);

/// Whether two closed segments have a point in common. Exact.
bool segments_touch(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

}  // namespace inkflate
