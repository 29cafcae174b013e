// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rect.h"
#include "render/draw_list.h"

namespace inkflate {

/// Shapes of which signs and frames are made.

/// A line as wide on the screen wherever its list is placed.
StrokedPolyline screen_line(Polyline points, double width_px, Colour colour);

/// The rim of a rectangle, closed.
Polyline rim(Rect const& box);

/// A ring, white inside and around, so that it shows on anything.
void add_ring(DrawList& list, Vec2 centre, double radius_px, Colour colour);

}  // namespace inkflate
