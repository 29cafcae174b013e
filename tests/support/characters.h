// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/drawing.h"

namespace inkflate {

/// Closed contours as simplify makes them, for tests: layers whose outlines are exact. Canvas 1000 x 1000 px.

/// A layer whose outline runs through the points in order, straight from one to the next; wholly drawn.
Layer drawn_layer(std::string name, Contour const& points);

/// A circle or ellipse, its points about 4 px apart.
Contour ellipse_contour(Vec2 centre, double radius_x, double radius_y);

/// A limb with a round end: a tube from its open mouth, whose middle is at `from`, to `to` (the middle of the round end's circle).
/// The mouth is a run of the given kind, the rest is ink.
Layer limb_layer(std::string name, Vec2 from, Vec2 to, double half_width_px,
                 RunKind mouth = RunKind::Closing);

/// Half a ring about the centre: the half with y above (false: below) it, both mouths on the line through the centre.
Layer half_ring_layer(std::string name, Vec2 centre, double inner_px, double outer_px,
                      bool is_above);

/// A ring: one layer with a hole.
Layer ring_layer(std::string name, Vec2 centre, double inner_px, double outer_px);

Drawing drawing_of(std::vector<Layer> layers);

/// A character of a body and limbs that lie over it or, every other one, behind it. 1: the body alone; 3: two limbs in front; 5: the same
/// limbs once more behind the body; more: limbs all around.
Drawing character(int layers);

}  // namespace inkflate
