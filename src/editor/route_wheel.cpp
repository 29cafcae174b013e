// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "editor/pointer_gesture.h"

namespace inkflate {
namespace {

// A trackpad's pinch comes as a Ctrl+wheel of a few px; a notch of a mouse has 100, and takes the largest step.
constexpr double kPinchPerPx = 0.01;
// Scrolling goes through hundreds of px: slower.
constexpr double kScrollPerPx = 0.002;
constexpr double kLargestStep = 0.2;

/// A step forth and one back give the same zoom again: (2 - x) / (2 + x) is nearly e^-x.
double zoom_factor(double delta_px, double per_px) {
  double const x = std::clamp(delta_px * per_px, -kLargestStep, kLargestStep);
  return (2 - x) / (2 + x);
}

}  // namespace

RouteStep route_wheel(PointerState const& state, WheelEvent const& event, View const& view) {
  RouteStep step = {state, {}};
  if (!is_finite(event.delta_px)) return step;
  bool const is_bending = state.use == PointerUse::Tool && state.tool == Tool::Deform;
  if (is_bending && !event.modifiers.is_ctrl) {
    step.routed.push_back(ToBendReach{zoom_factor(event.delta_px.y, kScrollPerPx)});
    return step;
  }
  bool const pans = view.mode == Mode::Draw && !event.modifiers.is_ctrl;
  if (pans) {
    // Some systems turn the wheel's direction themselves when Shift is held.
    auto const sideways = Vec2{event.delta_px.x + event.delta_px.y, 0};
    change_look(step, view, -(event.modifiers.is_shift ? sideways : event.delta_px), {}, 1);
  } else {
    double const per_px = event.modifiers.is_ctrl ? kPinchPerPx : kScrollPerPx;
    change_look(step, view, {}, event.screen, zoom_factor(event.delta_px.y, per_px));
  }
  return step;
}

RouteStep route_gesture(PointerState const& state, GestureEvent const& event, View const& view) {
  RouteStep step = {state, {}};
  change_look(step, view, event.moved_px, event.screen, event.scale);
  return step;
}

}  // namespace inkflate
