// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/stroke.h"
#include "render/draw_list.h"

namespace inkflate {

/// How wide the pen draws where it is pressed so, px.
double pressed_width(Stroke const& stroke, Sample const& sample);

/// A stroke as the pen drew it: its colour, and its width, thinner where the pen pressed less.
StrokedPolyline ink_line(Stroke const& stroke);

/// The same, but a help line is dashed and has the colour of help lines.
StrokedPolyline shown_line(Stroke const& stroke);

}  // namespace inkflate
