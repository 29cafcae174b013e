// SPDX-License-Identifier: Apache-2.0
#include "editor/pointer_gesture.h"

#include <algorithm>

#include "document/apply.h"

namespace inkflate {
namespace {

constexpr double kTurnPerPx = 0.01;    // rad: a drag of 314 px shows the other side
constexpr double kDoubleClickS = 0.4;  // between two presses; what desktops are set to
constexpr double kClickReachPx = 6;
constexpr double kFingerClickReachPx = 24;  // half a finger's width

ToolPointer tool_pointer(PointerState const& state, PointerEvent const& event, View const& view) {
  double const reach_px = DocumentLimits::kFarthestPx;
  auto const canvas = to_canvas(view.camera, view.size, event.screen);
  ToolPointer pointer;
  pointer.canvas = {std::clamp(canvas.x, -reach_px, reach_px),
                    std::clamp(canvas.y, -reach_px, reach_px)};
  pointer.screen = event.screen;
  pointer.pressure = event.kind == PointerKind::Pen ? event.pressure : 1;
  pointer.time_s = event.time_s;
  pointer.is_secondary = state.use == PointerUse::Tool && state.pointer.is_secondary;
  pointer.is_finger = event.kind == PointerKind::Touch;
  pointer.modifiers = event.modifiers;
  return pointer;
}

PointerUse use_of(PointerState const& state, DownPointer const& pointer, PointerEvent const& event,
                  View const& view) {
  bool const pans = state.is_space_held || pointer.button == PointerButton::Middle;
  if (view.mode != Mode::Draw) {
    bool const pans_model =
        pans || event.modifiers.is_shift || pointer.button == PointerButton::Secondary;
    return pans_model ? PointerUse::Pan : PointerUse::Turn;
  }
  if (pans) return PointerUse::Pan;
  if (pointer.button == PointerButton::Eraser) return PointerUse::Tool;
  bool const is_finger_beside_pen = pointer.kind == PointerKind::Touch && state.was_pen_seen;
  return view.tool == Tool::Hand || is_finger_beside_pen ? PointerUse::Pan : PointerUse::Tool;
}

/// 2: the second press of a double click.
int clicks_of(PointerState const& state, DownPointer const& pointer) {
  bool const is_second = state.clicks == 1 && pointer.kind == state.last_press_kind &&
                         pointer.button == state.last_press_button &&
                         pointer.first_time_s - state.last_press_time_s <= kDoubleClickS &&
                         distance(pointer.first, state.last_press) <= click_reach_px(pointer.kind);
  return is_second ? 2 : 1;
}

void press_tool(RouteStep& step, DownPointer const& pointer, PointerEvent const& event,
                View const& view) {
  auto& state = step.state;
  state.clicks = clicks_of(state, pointer);
  state.last_press = pointer.first;
  state.last_press_time_s = pointer.first_time_s;
  state.last_press_kind = pointer.kind;
  state.last_press_button = pointer.button;
  state.tool = pointer.button == PointerButton::Eraser ? Tool::Eraser : view.tool;
  state.pointer = tool_pointer(state, event, view);
  state.pointer.is_secondary = pointer.button == PointerButton::Secondary;
  step.routed.push_back(ToTool{state.tool, ToolPress{state.pointer, state.clicks}});
}

}  // namespace

double click_reach_px(PointerKind kind) {
  return kind == PointerKind::Touch ? kFingerClickReachPx : kClickReachPx;
}

void change_look(RouteStep& step, View const& view, Vec2 moved_px, Vec2 about, double factor) {
  if (view.mode == Mode::Draw) {
    auto const camera = zoomed(panned(view.camera, moved_px), view.size, about, factor);
    if (camera != view.camera) step.routed.push_back(ToCamera{camera});
  } else {
    step.routed.push_back(ToModel{zoomed(panned(view.model, moved_px), view.size, about, factor)});
  }
}

void begin_gesture(RouteStep& step, DownPointer const& pointer, PointerEvent const& event,
                   View const& view) {
  auto& state = step.state;
  auto const use = use_of(state, pointer, event, view);
  if (use == PointerUse::Tool) {
    press_tool(step, pointer, event, view);
  } else {
    state.clicks = 0;
  }
  state.use = use;
  state.tool_pointer = pointer.id;
}

void move_gesture(RouteStep& step, PointerEvent const& event, Vec2 from, View const& view) {
  auto& state = step.state;
  auto const moved = event.screen - from;
  if (state.use == PointerUse::Tool) {
    state.pointer = tool_pointer(state, event, view);
    if (event.action == PointerAction::Move) {
      step.routed.push_back(ToTool{state.tool, ToolMove{state.pointer}});
    }
  } else if (state.use == PointerUse::Pan) {
    change_look(step, view, moved, event.screen, 1);
  } else if (state.use == PointerUse::Turn) {
    // The near side follows the hand, so the viewer walks the other way.
    step.routed.push_back(ToModel{turned(view.model, -kTurnPerPx * moved.x, kTurnPerPx * moved.y)});
  }
}

void hover(RouteStep& step, PointerEvent const& event, View const& view) {
  if (step.state.use == PointerUse::Tool || view.mode != Mode::Draw) return;
  step.routed.push_back(ToTool{view.tool, ToolHover{tool_pointer(step.state, event, view)}});
}

void end_gesture(RouteStep& step, GestureEnd end) {
  auto& state = step.state;
  if (state.use == PointerUse::Tool) {
    ToolEvent event = ToolCancel{};
    if (end == GestureEnd::Keep) {
      state.pointer.time_s = state.last_time_s;
      event = ToolRelease{state.pointer};
    }
    step.routed.push_back(ToTool{state.tool, event});
  }
  if (end == GestureEnd::Drop) state.clicks = 0;
  state.use = PointerUse::None;
  state.tool_pointer = -1;
}

void ignore_all(RouteStep& step, GestureEnd end) {
  end_gesture(step, end);
  for (auto& pointer : step.state.down) pointer.is_ignored = true;
}

}  // namespace inkflate
