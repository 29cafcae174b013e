// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/drawing.h"
#include "render/draw_list.h"
#include "render/palette.h"

namespace inkflate {

/// With what outlines are drawn.
struct OutlinePen {
  double width_px = 2.5;       // > 0; dots and dashes follow it
  Colour ink = palette::kInk;  // of what was drawn
  WidthLimits limits = {};
  double tolerance_px = 0.05;  // > 0; finer than an antialiased picture can show
};

/// What the outlines enclose.
FilledPath outline_area(std::vector<Outline> const& outlines, double tolerance_px, Colour colour);

/// The outlines by their runs: ink as lines, closings dotted, help-line runs dashed.
DrawList outline_lines(std::vector<Outline> const& outlines, OutlinePen const& pen);

}  // namespace inkflate
