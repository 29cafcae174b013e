// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/drawing.h"
#include "render/draw_list.h"

namespace inkflate {

enum class RoughStrokes {
  Hidden,
  Faint,  // the strokes of the outlines and the stray ones, pale, under the shapes
};

struct DrawDrawingOptions {
  RoughStrokes rough_strokes = RoughStrokes::Hidden;
  double line_width_px = 2.5;  // > 0; outlines; dots and dashes follow it
};

/// The strokes as drawn: ink in its colour and width (thinner where the pen pressed less), help lines dashed.
DrawList draw_sketch(Sketch const& sketch);

/// What simplify made, in the studio's look: shapes filled, ink as lines, closings dotted, help-line runs dashed,
/// details thin in their own colours. Layers back to front; hidden ones are left out, and of one that has no outline yet the
/// strokes are drawn.
DrawList draw_drawing(Drawing const& drawing, DrawDrawingOptions const& options = {});

}  // namespace inkflate
