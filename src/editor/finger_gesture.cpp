// SPDX-License-Identifier: Apache-2.0
#include "editor/finger_gesture.h"

#include <algorithm>

#include "editor/pointer_gesture.h"

namespace inkflate {
namespace {

constexpr double kPalmS = 0.5;      // before and after a pen's event a touch is its hand's
constexpr double kTapS = 0.3;       // longer is no tap
constexpr double kTapReachPx = 10;  // farther is none either
// Fingers are never so near each other: below it the ratio of two distances means nothing.
constexpr double kLeastSpreadPx = 1;

bool is_finger(DownPointer const& pointer) {
  return pointer.kind == PointerKind::Touch && !pointer.is_ignored;
}

int finger_count(PointerState const& state) {
  return static_cast<int>(std::count_if(state.down.begin(), state.down.end(), is_finger));
}

bool is_pen_near(PointerState const& state) {
  bool const is_down = std::any_of(
      state.down.begin(), state.down.end(),
      [](DownPointer const& each) { return each.kind == PointerKind::Pen && !each.is_ignored; });
  return is_down || state.last_time_s - state.last_pen_time_s < kPalmS;
}

/// A mouse (or a pen) works; fingers have a use only among themselves.
bool is_other_at_work(PointerState const& state) {
  return state.use != PointerUse::None && finger_count(state) == 0;
}

/// Where fingers are, and how far from each other.
struct Hand {
  Vec2 centre;
  double spread_px = 0;  // mean distance from the centre
};

Hand hand_of(PointerState const& state) {
  int const count = finger_count(state);
  Hand hand;
  for (auto const& each : state.down) {
    if (is_finger(each)) hand.centre += each.last / count;
  }
  for (auto const& each : state.down) {
    if (is_finger(each)) hand.spread_px += distance(each.last, hand.centre) / count;
  }
  return hand;
}

}  // namespace

void press_finger(RouteStep& step, DownPointer finger, PointerEvent const& event,
                  View const& view) {
  auto& state = step.state;
  finger.is_ignored = is_pen_near(state) || is_other_at_work(state);
  state.down.push_back(finger);
  if (finger.is_ignored) return;
  int const count = finger_count(state);
  if (count == 1) {
    state.fingers_from_s = event.time_s;
    state.fingers_at_most = 1;
    state.has_pinched = false;
    begin_gesture(step, finger, event, view);
    return;
  }
  end_gesture(step, GestureEnd::Drop);
  state.use = PointerUse::Pinch;
  state.fingers_at_most = std::max(state.fingers_at_most, count);
}

void move_pinch(RouteStep& step, int index, PointerEvent const& event, View const& view) {
  auto& state = step.state;
  auto const before = hand_of(state);
  state.down[index].last = event.screen;
  // Fingers that tap tremble; the paper must not.
  if (!state.has_pinched) return;
  auto const after = hand_of(state);
  bool const is_apart = before.spread_px > kLeastSpreadPx && after.spread_px > kLeastSpreadPx;
  change_look(step, view, after.centre - before.centre, after.centre,
              is_apart ? after.spread_px / before.spread_px : 1);
}

void lift_finger(RouteStep& step, FingerEnd end) {
  auto& state = step.state;
  if (end == FingerEnd::Lost) state.has_pinched = true;
  int const count = finger_count(state);
  if (state.use == PointerUse::Pinch && count < 2) state.use = PointerUse::Ignored;
  if (count > 0) return;
  if (state.use == PointerUse::Ignored) state.use = PointerUse::None;
  bool const is_tap = !state.has_pinched && state.last_time_s - state.fingers_from_s < kTapS;
  if (is_tap && state.fingers_at_most == 2) step.routed.push_back(ToAction{"undo"});
  if (is_tap && state.fingers_at_most == 3) step.routed.push_back(ToAction{"redo"});
}

void watch_tap(PointerState& state, DownPointer const& finger) {
  bool const is_tap =
      finger.farthest_px < kTapReachPx && state.last_time_s - state.fingers_from_s < kTapS;
  if (!is_tap) state.has_pinched = true;
}

void reject_palms(RouteStep& step) {
  auto const& state = step.state;
  bool const is_palm =
      std::any_of(state.down.begin(), state.down.end(), [&](DownPointer const& each) {
        return is_finger(each) && state.last_time_s - each.first_time_s < kPalmS;
      });
  if (is_palm) ignore_all(step, GestureEnd::Drop);
}

}  // namespace inkflate
