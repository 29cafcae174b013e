// SPDX-License-Identifier: Apache-2.0
#include "support/tool_hand.h"

#include <utility>

#include "document/apply.h"

namespace inkflate {

ToolHand::ToolHand(Tool tool, Document document)
    : tool_(tool), before_(document), shown_(std::move(document)) {
  view.tool = tool;
  // At zoom 1 with the middle of the paper in the middle: screen and canvas are the same.
  view.size = {1000, 1000};
  view.camera = {{500, 500}, 1, false};
}

ToolPointer ToolHand::pointer(Vec2 screen) {
  time_s_ += 0.01;
  return {to_canvas(view.camera, view.size, screen),
          screen,
          pressure,
          time_s_,
          is_secondary,
          modifiers};
}

Step ToolHand::take(ToolEvent const& event) {
  auto step = tool_step(tool_, std::move(state_), event, {shown_, view});
  state_ = step.state;
  if (step.effect == GestureEffect::Replace) gesture_ = step.commands;
  if (step.effect == GestureEffect::Append) {
    gesture_.insert(gesture_.end(), step.commands.begin(), step.commands.end());
  }
  shown_ = before_;
  if (!gesture_.empty()) {
    auto next = inkflate::apply(before_, gesture_);
    if (next) shown_ = *next;
    was_refused_ = was_refused_ || !next;
  }
  if (step.is_end) {
    if (!gesture_.empty()) ++entries_;
    gesture_.clear();
    before_ = shown_;
  }
  if (step.selection) view.selection = *step.selection;
  if (step.hover) view.hover = *step.hover;
  if (step.camera) view.camera = *step.camera;
  return step;
}

Step ToolHand::press(Vec2 screen, int clicks) { return take(ToolPress{pointer(screen), clicks}); }
Step ToolHand::move(Vec2 screen) { return take(ToolMove{pointer(screen)}); }
Step ToolHand::hover(Vec2 screen) { return take(ToolHover{pointer(screen)}); }
Step ToolHand::release(Vec2 screen) { return take(ToolRelease{pointer(screen)}); }
Step ToolHand::cancel() { return take(ToolCancel{}); }

Step ToolHand::drag(Vec2 from, Vec2 to) {
  constexpr int steps = 8;
  press(from);
  for (int i = 1; i <= steps; ++i) move(lerp(from, to, static_cast<double>(i) / steps));
  return release(to);
}

Step ToolHand::click(Vec2 screen, int clicks) {
  press(screen, clicks);
  return release(screen);
}

}  // namespace inkflate
