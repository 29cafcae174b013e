// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace inkflate {

/// Moves the corners of triangles that lie folded back onto all three of their neighbours to the middle of what is around them, until
/// none is left or a few dozen rounds are over.
///
/// in      triangles: of a closed surface; is_movable: one per point, what may be moved
/// cost    O(movable triangles) per round; one round where nothing is folded
void unfold(std::span<Triangle const> triangles, std::vector<bool> const& is_movable,
            std::vector<Vec3>& points);

}  // namespace inkflate
