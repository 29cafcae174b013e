// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "deform/shape_mesh.h"
#include "mesh/triangle_grid.h"

namespace inkflate {

/// Where the points of a line lie in a shape that lies over itself: each in the sheet of the one before it, if that is there. It begins where
/// there is one sheet alone, and goes both ways; a line that is nowhere so, and a point that comes from outside, is in the smallest.
///
/// in      shape: with sheets; triangles: of its mesh
/// out     one per point; nothing where it is outside
std::vector<std::optional<MeshPlace>> line_in_sheets(ShapeMesh const& shape,
                                                     TriangleGrid const& triangles,
                                                     std::span<Vec2 const> line);

}  // namespace inkflate
