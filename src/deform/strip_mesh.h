// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "deform/line_samples.h"
#include "deform/shape_mesh.h"

namespace inkflate {

/// Half of the width that strips have in a shape of this size, px.
double strip_half_width_px(double longer_side_px);

/// How far apart the spine's vertices of a line shall be, px: at most 200 of them.
double spine_edge_px(double length_px, double half_width_px);

/// Gives a mesh a strip along a line, of two rows of triangles with the line as its spine. It is narrower where the line bends more
/// tightly or its points are closer than its width, and wedges fill the outer side of sharp corners; strips may lie over themselves
/// and one another.
///
/// in      line: at least two points, three if closed, none equal to the next; origin: index of the line in its shape
///         half_width_px: > 0
/// out     every triangle has positive area
/// cost    O(n)
void add_strip(ShapeMesh& shape, LineSamples const& line, int origin, double half_width_px);

/// Gives a mesh four triangles around a place.
void add_dot(ShapeMesh& shape, Vec2 place, int origin, double half_width_px);

/// A strip for each line, a dot for each that is shorter than can be seen; lines without a point have none. Dots are made only where
/// nothing else is there: else they ride.
///
/// in      lines: sampled finely; half_width_px > 0
ShapeMesh strip_mesh(std::span<LineSamples const> lines, double half_width_px);

}  // namespace inkflate
