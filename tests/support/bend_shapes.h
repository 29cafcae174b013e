// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "deform/bend_options.h"
#include "deform/bender.h"

namespace inkflate::support {

/// Shapes to bend, for tests. Lengths in px.

/// One straight piece per side.
Outline polygon_outline(Contour const& corners);
/// Four pieces; is_hole: the other way round.
Outline disc_outline(Vec2 centre, double radius, bool is_hole = false);
/// From (0, 0) to (length, width), one piece per side.
Outline bar_outline(double length, double width);
/// A ring with an eye, a whisker that sticks out, a dot, and ink, closing and help-line pieces with sources.
BendShape face_shape(double radius);
/// An outline that crosses itself: the two ends of a band lie over each other.
Outline crossing_outline(double size);
/// The corners of a body, (0, 0) to (200, 200), with a limb at its right side that is bent back over it: between y = 40 and 80 it reaches
/// from x = 300 to 120.
Contour folded_limb_corners();

/// The line y = middle becomes an arc of this angle that is as long; what is beside it keeps its distance.
std::function<Vec2(Vec2)> arc_map(double length, double middle, double angle_rad);

/// A strong bend of a shape in 0 .. size, the same for all of it.
std::function<Vec2(Vec2)> strong_bend(BendShape const& shape);

inline constexpr std::array kBendModes = {BendMode::Body, BendMode::Wire};
/// in      shape: something to bend
Bender made_bender(BendShape const& shape, BendMode mode = BendMode::Body);

BendPose posed(BendPose const& rest, std::function<Vec2(Vec2)> const& map);

/// Twice the area of the smallest triangle.
double least_area(FlatMesh const& mesh, std::vector<Vec2> const& points);

/// The farthest that a control point or a point of a line of `is` lies from that of `wanted`; infinite where their numbers differ.
double largest_difference(BendShape const& is, BendShape const& wanted);

/// All control points and points, moved.
BendShape mapped(BendShape shape, std::function<Vec2(Vec2)> const& map);

}  // namespace inkflate::support
