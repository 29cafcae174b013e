// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "document/document.h"
#include "editor/tool.h"
#include "editor/view.h"
#include "pipeline/close_document.h"
#include "render/draw_list.h"

namespace inkflate {

/// Draw lists of what is no part of the drawing but helps to make it. Empty: there is nothing to show.

/// On the canvas: the picture to trace, pale, as large as fits on the document's canvas.
DrawList draw_template(Document const& document);

/// On the canvas: the shape that would be made, to lie under the ink; and the bridges over its gaps, to lie over it.
DrawList draw_preview_area(ShapePreview const& preview);
DrawList draw_preview_closings(ShapePreview const& preview);

/// On the canvas: the line that a tool is drawing, or the box around layers.
DrawList draw_tool(ToolState const& tool);

/// On the screen: a ring for each place that a person has marked, with a plus where it belongs to the shape, a minus where it is background. For
/// what is rough; with the Mark tool also for closed layers. Only those in view.
DrawList draw_marks(Document const& document, View const& view);

}  // namespace inkflate
