// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/vec2.h"

namespace inkflate {

/// The place on a line that is nearest to a point.
struct SeamPlace {
  double distance_px = 0;
  int edge = 0;      // between the line's points edge and edge + 1
  double share = 0;  // of that edge
  double side = 0;   // > 0: the point lies on the limb's side of the line; 0: beyond an end of it
};

/// line: at least two points, in outline order of the limb. O(points).
SeamPlace nearest_on_seam(std::span<Vec2 const> line, Vec2 p);

}  // namespace inkflate
