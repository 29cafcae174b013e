// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "document/apply.h"
#include "editor/pick_bend.h"
#include "editor/pins.h"
#include "editor/tools.h"
#include "editor/turn_step.h"
#include "geometry/trig.h"
#include "io/numbers.h"

namespace inkflate {
namespace {

// A click of a hand that is not quite still, as with Select.
constexpr double kDragThresholdPx = 4;
// Screen px.
constexpr double kPinReachPx = 10;
constexpr double kFingerReachFactor = 2.2;  // half a finger's width from a pin's middle

template <typename State>
Step step_to(State state) {
  Step step;
  step.state = std::move(state);
  return step;
}

double reach_factor(ToolPointer const& pointer) {
  return pointer.is_finger ? kFingerReachFactor : 1;
}

std::optional<BendHit> hit_at(ToolPointer const& pointer, ToolContext const& context) {
  auto const depth = pointer.is_secondary ? PickDepth::Farthest : PickDepth::Nearest;
  return pick_to_bend(context.document, pointer.canvas,
                      pick_reach_px(context.view) * reach_factor(pointer), depth);
}

bool is_on_knob(ToolPointer const& pointer, ToolContext const& context) {
  auto const& selected = context.view.pin;
  auto const* const pin = selected ? find_pin(context.document, *selected) : nullptr;
  return pin != nullptr && distance(pin_knob(*pin, context.view), pointer.screen) <=
                               kPinReachPx * reach_factor(pointer);
}

bool is_on_locked(ToolPointer const& pointer, ToolContext const& context) {
  auto const& layers = *context.document.layers;
  return std::any_of(layers.begin(), layers.end(), [&](auto const& layer) {
    return layer->layer.is_locked && !layer->layer.is_hidden &&
           is_under(*layer, pointer.canvas, pick_reach_px(context.view));
  });
}

BendGrab grab_of(BendPinRef const& pin, Document const& document) {
  return {pin.layer, {}, pin.index, find_pin(document, pin)->position};
}

ToolPressedToBend pressed_at(ToolPointer const& pointer, ToolContext const& context) {
  auto const& document = context.document;
  if (is_on_knob(pointer, context)) {
    return {pointer, BendPress::Knob, grab_of(*context.view.pin, document)};
  }
  auto const reach_px = kPinReachPx * reach_factor(pointer);
  if (auto const pin = pick_pin(document, context.view, pointer.screen, reach_px)) {
    return {pointer, BendPress::Pin, grab_of(*pin, document)};
  }
  if (auto const hit = hit_at(pointer, context)) {
    return {pointer, hit->is_on_line ? BendPress::Line : BendPress::Inside, hit->what};
  }
  return {pointer, is_on_locked(pointer, context) ? BendPress::Locked : BendPress::Nothing};
}

/// The way of the hand around the pin, in small turns, so that it can go round more than once.
double turned_rad(Vec2 pin, Vec2 from, Vec2 to) {
  auto const a = from - pin;
  auto const b = to - pin;
  return atan2_of(cross(a, b), dot(a, b));
}

Step bend_to(ToolBending bend, ToolPointer const& now) {
  if (bend.turn_rad) {
    bend.hand_rad += turned_rad(bend.what.place, bend.last, now.canvas);
    bool const is_stepped = now.modifiers.is_shift;
    bend.turn_rad =
        is_stepped ? kTurnStepRad * std::round(bend.hand_rad / kTurnStepRad) : bend.hand_rad;
  } else {
    double const far = DocumentLimits::kFarthestPx;
    auto const target = bend.what.place + (now.canvas - bend.from.canvas);
    bend.target = {std::clamp(target.x, -far, far), std::clamp(target.y, -far, far)};
  }
  bend.last = now.canvas;
  Step step;
  step.bend = bend;
  step.state = bend;
  return step;
}

/// What is held is what one goes on with.
void select_held(Step& step, ToolPressedToBend const& pressed, View const& view) {
  auto const& what = pressed.what;
  bool const is_pin = pressed.on == BendPress::Pin;
  if (is_pin) step.pin = BendPinRef{what.layer, *what.pin};
  std::vector<LayerId> selection = {what.layer};
  if (what.layer != LayerId::None && selection != view.selection) {
    step.selection = std::move(selection);
  }
}

Step refusal(Word word) {
  Step step;
  step.word = word;
  return step;
}

Step start_bend(ToolPressedToBend const& pressed, ToolPointer const& now, View const& view) {
  if (pressed.on == BendPress::Nothing) return refusal(Word::NothingToBend);
  if (pressed.on == BendPress::Locked) return refusal(Word::PartLocked);
  ToolBending bend = {pressed.what, pressed.from, pressed.what.place};
  bend.last = pressed.from.canvas;
  if (pressed.on == BendPress::Knob) bend.turn_rad = 0;
  auto step = bend_to(bend, now);
  select_held(step, pressed, view);
  return step;
}

Step move_step(ToolState const& state, ToolPointer const& now, View const& view) {
  if (auto const* pressed = std::get_if<ToolPressedToBend>(&state)) {
    bool const is_drag = distance(pressed->from.screen, now.screen) >= kDragThresholdPx;
    return is_drag ? start_bend(*pressed, now, view) : step_to(*pressed);
  }
  auto const* bend = std::get_if<ToolBending>(&state);
  return bend == nullptr ? Step{} : bend_to(*bend, now);
}

/// A pin where the line is; pins belong to parts.
void put_pin(Step& step, BendGrab const& what) {
  if (what.layer == LayerId::None) {
    step.word = Word::NotYetPart;
    return;
  }
  step.action = "add_pin";
  append_number(step.argument, what.place.x);
  step.argument += ',';
  append_number(step.argument, what.place.y);
}

Step clicked(ToolPressedToBend const& pressed, View const& view) {
  auto step = finished();
  if (pressed.on == BendPress::Knob) return step;
  if (pressed.on == BendPress::Locked) step.word = Word::PartLocked;
  step.pin.emplace();
  bool const is_held = pressed.on != BendPress::Nothing && pressed.on != BendPress::Locked;
  if (is_held) {
    select_held(step, pressed, view);
  } else {
    step.selection.emplace();
  }
  if (pressed.on == BendPress::Line) put_pin(step, pressed.what);
  if (pressed.on == BendPress::Pin && pressed.from.modifiers.is_alt) step.action = "delete";
  return step;
}

Step hover_over(ToolPointer const& pointer, ToolContext const& context) {
  auto const hit = hit_at(pointer, context);
  auto const layer = hit ? hit->what.layer : LayerId::None;
  Step step;
  if (layer != context.view.hover) step.hover = layer;
  return step;
}

}  // namespace

Step deform_step(ToolState const& state, ToolEvent const& event, ToolContext const& context) {
  if (auto const* hover = std::get_if<ToolHover>(&event)) {
    return hover_over(hover->pointer, context);
  }
  if (auto const* press = std::get_if<ToolPress>(&event)) {
    return step_to(pressed_at(press->pointer, context));
  }
  if (auto const* move = std::get_if<ToolMove>(&event)) {
    return move_step(state, move->pointer, context.view);
  }
  auto step = move_step(state, std::get<ToolRelease>(event).pointer, context.view);
  if (auto const* pressed = std::get_if<ToolPressedToBend>(&step.state)) {
    return clicked(*pressed, context.view);
  }
  step.state = ToolIdle{};
  step.is_end = true;
  return step;
}

}  // namespace inkflate
