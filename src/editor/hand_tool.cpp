// SPDX-License-Identifier: Apache-2.0
#include "editor/tools.h"

namespace inkflate {

Step hand_step(ToolState const& state, ToolEvent const& event, ToolContext const& context) {
  if (std::holds_alternative<ToolHover>(event)) return {};
  if (auto const* press = std::get_if<ToolPress>(&event)) {
    Step step;
    step.state = ToolPanning{press->pointer.screen};
    return step;
  }
  auto const* panning = std::get_if<ToolPanning>(&state);
  if (panning == nullptr) return {};
  auto const* release = std::get_if<ToolRelease>(&event);
  auto const now =
      release != nullptr ? release->pointer.screen : std::get<ToolMove>(event).pointer.screen;
  Step step;
  if (release != nullptr) {
    step = finished();
  } else {
    step.state = ToolPanning{now};
  }
  if (now != panning->last) step.camera = panned(context.view.camera, now - panning->last);
  return step;
}

}  // namespace inkflate
