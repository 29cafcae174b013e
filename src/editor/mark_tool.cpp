// SPDX-License-Identifier: Apache-2.0
#include "editor/pick.h"
#include "editor/tools.h"
#include "io/numbers.h"

namespace inkflate {

Step mark_step(ToolState const& state, ToolEvent const& event, ToolContext const& context) {
  if (auto const* hover = std::get_if<ToolHover>(&event)) {
    return hover_step(hover->pointer, context, pick_reach_px(context.view));
  }
  if (auto const* press = std::get_if<ToolPress>(&event)) {
    Step step;
    step.state = ToolPressedOn{press->pointer, LayerId::None, press->clicks};
    return step;
  }
  auto const* pressed = std::get_if<ToolPressedOn>(&state);
  if (pressed == nullptr) return {};
  if (std::holds_alternative<ToolMove>(event)) {
    Step step;
    step.state = state;
    return step;
  }
  // A hand that slips while it clicks still means the place where it pressed.
  auto const& from = pressed->from;
  Step step = finished();
  step.action = from.is_secondary || from.modifiers.is_alt ? "mark_inside" : "mark_outside";
  append_number(step.argument, from.canvas.x);
  step.argument += ',';
  append_number(step.argument, from.canvas.y);
  return step;
}

}  // namespace inkflate
