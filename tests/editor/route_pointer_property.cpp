// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>

#include "editor/route_pointer.h"

namespace inkflate {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kHostile[] = {std::numeric_limits<double>::quiet_NaN(),
                               kInfinite,
                               -kInfinite,
                               1e300,
                               -1e300,
                               0,
                               -0.0,
                               1e-300};

/// Mostly what a screen gives, sometimes what it cannot.
double arbitrary_number() {
  int const which = *rc::gen::inRange(0, 80);
  return which < std::ssize(kHostile) ? kHostile[which] : *rc::gen::inRange(-100, 1100) / 1.0;
}

PointerEvent arbitrary_event() {
  PointerEvent event;
  event.action = static_cast<PointerAction>(*rc::gen::inRange(0, 4));
  event.id = *rc::gen::inRange(-1, 6);
  // Mostly the same kind for an id, as systems do; sometimes not.
  int const kind = *rc::gen::inRange(0, 10) > 0 ? (event.id + 1) / 2 : *rc::gen::inRange(0, 3);
  event.kind = static_cast<PointerKind>(std::min(kind, 2));
  event.button = static_cast<PointerButton>(*rc::gen::inRange(0, 5));
  event.screen = {arbitrary_number(), arbitrary_number()};
  event.pressure = arbitrary_number() / 1000;
  event.time_s = arbitrary_number() / 100;
  event.modifiers.is_shift = *rc::gen::inRange(0, 8) == 0;
  return event;
}

/// What tool_step may rely on.
struct Listener {
  bool is_pressed = false;
  Tool tool = Tool::Brush;
  double time_s = 0;

  void hear(ToolPointer const& pointer) {
    RC_ASSERT(is_finite(pointer.canvas) && is_finite(pointer.screen));
    RC_ASSERT(std::abs(pointer.canvas.x) <= 1e6 && std::abs(pointer.canvas.y) <= 1e6);
    RC_ASSERT(pointer.pressure >= 0 && pointer.pressure <= 1);
    RC_ASSERT(pointer.time_s >= time_s);
    time_s = pointer.time_s;
  }

  void hear(Tool for_tool, ToolPress const& press) {
    RC_ASSERT(!is_pressed);
    RC_ASSERT(press.clicks == 1 || press.clicks == 2);
    is_pressed = true;
    tool = for_tool;
    hear(press.pointer);
  }
  void hear(Tool for_tool, ToolMove const& move) {
    RC_ASSERT(is_pressed && for_tool == tool);
    hear(move.pointer);
  }
  void hear(Tool, ToolHover const& hover) {
    RC_ASSERT(!is_pressed);
    hear(hover.pointer);
  }
  void hear(Tool for_tool, ToolRelease const& release) {
    RC_ASSERT(is_pressed && for_tool == tool);
    is_pressed = false;
    hear(release.pointer);
  }
  void hear(Tool for_tool, ToolCancel const&) {
    RC_ASSERT(is_pressed && for_tool == tool);
    is_pressed = false;
  }
};

void take(RouteStep step, PointerState& state, View& view, Listener& listener) {
  state = std::move(step.state);
  for (auto const& each : step.routed) {
    if (auto const* camera = std::get_if<ToCamera>(&each)) view.camera = camera->camera;
    if (auto const* model = std::get_if<ToModel>(&each)) view.model = model->model;
    if (auto const* to_tool = std::get_if<ToTool>(&each)) {
      std::visit([&](auto const& event) { listener.hear(to_tool->tool, event); }, to_tool->event);
    }
  }
  RC_ASSERT(is_finite(view.camera.centre) && std::abs(view.camera.centre.x) <= 1e6);
  RC_ASSERT(view.camera.zoom >= Camera::kLeastZoom && view.camera.zoom <= Camera::kLargestZoom);
  RC_ASSERT(is_finite(view.model.pan_px) && std::abs(view.model.turn_rad) < 4);
  RC_ASSERT(view.model.zoom >= kLeastModelZoom && view.model.zoom <= kLargestModelZoom);
}

RC_GTEST_PROP(RoutePointer, EveryPressEndsOnceWhateverComes, ()) {
  PointerState state;
  View view;
  Listener listener;
  for (int i = 0; i < 300; ++i) {
    int const what = *rc::gen::inRange(0, 30);
    if (what == 0) {
      take(drop_pointers(state), state, view, listener);
      RC_ASSERT(!listener.is_pressed);
    } else if (what == 1) {
      view.mode = static_cast<Mode>(*rc::gen::inRange(0, 3));
      view.tool = static_cast<Tool>(*rc::gen::inRange(0, 6));
      state.is_space_held = *rc::gen::inRange(0, 3) == 0;
    } else if (what == 2) {
      WheelEvent const wheel = {{arbitrary_number(), arbitrary_number()},
                                {arbitrary_number(), arbitrary_number()},
                                {*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), false}};
      take(route_wheel(state, wheel, view), state, view, listener);
    } else if (what == 3) {
      GestureEvent const pinch = {{arbitrary_number(), arbitrary_number()},
                                  arbitrary_number(),
                                  {arbitrary_number(), arbitrary_number()}};
      take(route_gesture(state, pinch, view), state, view, listener);
    } else {
      take(route_pointer(state, arbitrary_event(), view), state, view, listener);
    }
    RC_ASSERT((state.use == PointerUse::Tool) == listener.is_pressed);
  }
}

}  // namespace
}  // namespace inkflate
