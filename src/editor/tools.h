// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "editor/tool.h"
#include "model/stroke.h"

namespace inkflate {

/// The transitions of each tool: those of tool_step, for pointers that are finite and within reach, for presses, moves, releases
/// and hovers that come when they may. A state that is none of the tool's becomes idle.

/// Brush and HelpLine.
Step brush_step(StrokeKind kind, ToolState state, ToolEvent const& event,
                ToolContext const& context);
Step eraser_step(ToolState const& state, ToolEvent const& event, ToolContext const& context);
Step select_step(ToolState const& state, ToolEvent const& event, ToolContext const& context);
Step deform_step(ToolState const& state, ToolEvent const& event, ToolContext const& context);
Step mark_step(ToolState const& state, ToolEvent const& event, ToolContext const& context);
Step hand_step(ToolState const& state, ToolEvent const& event, ToolContext const& context);

/// A gesture that is over, with what it has done.
inline Step finished() {
  Step step;
  step.is_end = true;
  return step;
}

/// The layer under a pointer becomes the hovered one.
Step hover_step(ToolPointer const& pointer, ToolContext const& context, double reach_px);

/// Within limits; NaN counts as the least.
inline double bounded(double value, double least, double largest) {
  return value >= least ? std::min(value, largest) : least;
}

/// How near to a rim a pointer counts as on it, canvas px.
double pick_reach_px(View const& view);

/// Where a new stroke goes: to the one open layer that is selected, if there is exactly one; else to the topmost open layer; else it is
/// loose. Hidden and locked layers get none.
LayerId layer_to_draw_on(Document const& document, View const& view);

}  // namespace inkflate
