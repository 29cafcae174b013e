// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "deform/bend_mesh.h"
#include "geometry/polyline.h"

namespace inkflate {

/// The thesis' strip: a band of triangles on both sides of every contour.
///
/// in      half_width_px: finite; 0 or less: as wide as the mean edge of the contour. Points: finite
/// out     for each contour of s points in turn: its points, s vertices above them (outside, of an outer contour), s vertices
///         below; 4 s triangles in the order of F(i), F(i+s), F(i+2s), F(i+3s), each turned so that its area is not negative.
///         Triangles overlap where the strip is wider than the line's bends, and at spikes. They have no area where neighbouring
///         points coincide, which WireSolver bears. A single point has no triangles
/// cost    O(s)
/// source  thesis, section 4.2, eq. 4.1 and figures 4.7, 4.8
BendMesh wire_strip(std::span<Contour const> contours, double half_width_px);

/// The same for open lines: a line of s points has 3 s vertices and 4 (s - 1) triangles.
BendMesh open_wire_strip(std::span<Polyline const> lines, double half_width_px);

}  // namespace inkflate
