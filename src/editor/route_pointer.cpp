// SPDX-License-Identifier: Apache-2.0
#include "editor/route_pointer.h"

#include <algorithm>
#include <cmath>

#include "editor/finger_gesture.h"
#include "editor/pointer_gesture.h"

namespace inkflate {
namespace {

// Nobody has more fingers and pens; more are pointers whose release was lost.
constexpr std::ptrdiff_t kMostPointers = 32;
constexpr double kFarthestScreenPx = 1e6;

/// -1: no such pointer is down.
int find_down(PointerState const& state, int id) {
  for (int i = 0; i < std::ssize(state.down); ++i) {
    if (state.down[i].id == id) return i;
  }
  return -1;
}

bool works_alone(PointerState const& state, int id) {
  bool const is_single = state.use == PointerUse::Tool || state.use == PointerUse::Pan ||
                         state.use == PointerUse::Turn;
  return is_single && state.tool_pointer == id;
}

bool has_place(PointerEvent const& event) { return is_finite(event.screen); }

/// The event with numbers that can be: place within reach, time not before the last.
PointerEvent cleaned(PointerState const& state, PointerEvent event) {
  if (has_place(event)) {
    event.screen = {std::clamp(event.screen.x, -kFarthestScreenPx, kFarthestScreenPx),
                    std::clamp(event.screen.y, -kFarthestScreenPx, kFarthestScreenPx)};
  }
  event.pressure = std::isfinite(event.pressure) ? std::clamp(event.pressure, 0.0, 1.0) : 0.5;
  event.time_s =
      std::isfinite(event.time_s) ? std::max(event.time_s, state.last_time_s) : state.last_time_s;
  return event;
}

enum class Lift {
  Released,
  Cancelled,
  Lost,  // the release never came
};

void lift(RouteStep& step, int index, Lift how) {
  auto& state = step.state;
  auto const pointer = state.down[index];
  state.down.erase(state.down.begin() + index);
  if (pointer.is_ignored) return;
  if (works_alone(state, pointer.id)) {
    end_gesture(step, how == Lift::Cancelled ? GestureEnd::Drop : GestureEnd::Keep);
    if (pointer.farthest_px > click_reach_px(pointer.kind)) state.clicks = 0;
  }
  if (pointer.kind == PointerKind::Touch) {
    lift_finger(step, how == Lift::Released ? FingerEnd::Lifted : FingerEnd::Lost);
  }
}

/// Of this pointer; and as there is one mouse and one pen, of any other of its kind.
void lift_lost(RouteStep& step, PointerEvent const& event) {
  auto& down = step.state.down;
  for (int i = static_cast<int>(std::ssize(down)) - 1; i >= 0; --i) {
    bool const is_same_device = event.kind != PointerKind::Touch && down[i].kind == event.kind;
    if (down[i].id == event.id || is_same_device) lift(step, i, Lift::Lost);
  }
  if (std::ssize(down) >= kMostPointers) lift(step, 0, Lift::Lost);
}

void press(RouteStep& step, PointerEvent const& event, View const& view) {
  if (!has_place(event)) return;
  lift_lost(step, event);
  DownPointer pointer;
  pointer.id = event.id;
  pointer.kind = event.kind;
  pointer.button = event.button == PointerButton::None ? PointerButton::Primary : event.button;
  pointer.first = pointer.last = event.screen;
  pointer.first_time_s = event.time_s;
  if (event.kind == PointerKind::Touch) {
    press_finger(step, pointer, event, view);
    return;
  }
  ignore_all(step, GestureEnd::Keep);
  step.state.down.push_back(pointer);
  begin_gesture(step, pointer, event, view);
}

/// The pointer is at another place, with all that follows from it.
void follow(RouteStep& step, int index, PointerEvent const& event, View const& view) {
  auto& state = step.state;
  auto& pointer = state.down[index];
  pointer.farthest_px = std::max(pointer.farthest_px, distance(pointer.first, event.screen));
  if (pointer.is_ignored) return;
  if (pointer.kind == PointerKind::Touch) watch_tap(state, pointer);
  if (state.use == PointerUse::Pinch) {
    move_pinch(step, index, event, view);
  } else if (works_alone(state, pointer.id)) {
    move_gesture(step, event, pointer.last, view);
  }
  pointer.last = event.screen;
}

void move(RouteStep& step, PointerEvent const& event, View const& view) {
  if (!has_place(event)) return;
  int const index = find_down(step.state, event.id);
  if (index >= 0) {
    follow(step, index, event, view);
  } else if (event.kind != PointerKind::Touch) {
    hover(step, event, view);
  }
}

void release(RouteStep& step, PointerEvent event, View const& view) {
  int const index = find_down(step.state, event.id);
  if (index < 0) return;
  auto const& pointer = step.state.down[index];
  // The button of a mouse that was pressed before another one took over.
  bool const is_other_button = pointer.kind == PointerKind::Mouse &&
                               event.button != PointerButton::None &&
                               event.button != pointer.button;
  if (is_other_button && event.action == PointerAction::Release) return;
  if (event.action == PointerAction::Cancel) {
    lift(step, index, Lift::Cancelled);
    return;
  }
  if (!has_place(event)) event.screen = pointer.last;
  follow(step, index, event, view);
  lift(step, index, Lift::Released);
}

}  // namespace

RouteStep route_pointer(PointerState const& state, PointerEvent const& event, View const& view) {
  RouteStep step = {state, {}};
  auto const clean = cleaned(state, event);
  step.state.last_time_s = clean.time_s;
  if (clean.kind == PointerKind::Pen) {
    reject_palms(step);
    step.state.last_pen_time_s = clean.time_s;
    if (clean.action == PointerAction::Press) step.state.was_pen_seen = true;
  }
  switch (clean.action) {
    case PointerAction::Press:
      press(step, clean, view);
      break;
    case PointerAction::Move:
      move(step, clean, view);
      break;
    case PointerAction::Release:
    case PointerAction::Cancel:
      release(step, clean, view);
      break;
  }
  return step;
}

RouteStep drop_pointers(PointerState const& state) {
  RouteStep step = {state, {}};
  ignore_all(step, GestureEnd::Drop);
  return step;
}

}  // namespace inkflate
