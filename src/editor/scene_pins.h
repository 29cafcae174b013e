// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "document/document.h"
#include "editor/tool.h"
#include "editor/view.h"
#include "render/draw_list.h"

namespace inkflate {

/// On the screen, with the Deform tool: the pins of all parts that are seen, a ring with a knob around the selected one, the held place,
/// and the reach while it is changed. A pin that does not turn freely points where it has been turned to; one of a locked part
/// is hollow. Only those in view. Empty: there is nothing to show.
DrawList draw_pins(Document const& document, View const& view, ToolState const& tool);

}  // namespace inkflate
