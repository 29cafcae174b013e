// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "geometry/vec2.h"

namespace inkflate {

/// Where on the segment from a to b its place nearest to p lies: 0 at a, 1 at b; 0 where the segment has no length.
inline double share_along(Vec2 p, Vec2 a, Vec2 b) {
  Vec2 const along = b - a;
  double const size = squared_norm(along);
  return size > 0 ? std::clamp(dot(p - a, along) / size, 0.0, 1.0) : 0;
}

/// The place of the segment that is nearest to p.
inline Vec2 nearest_on_segment(Vec2 p, Vec2 a, Vec2 b) {
  return a + (b - a) * share_along(p, a, b);
}

}  // namespace inkflate
