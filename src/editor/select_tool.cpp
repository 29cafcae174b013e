// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include "editor/layer_commands.h"
#include "editor/pick.h"
#include "editor/tools.h"
#include "editor/transform_drag.h"

namespace inkflate {
namespace {

// A click of a hand that is not quite still.
constexpr double kDragThresholdPx = 4;
constexpr double kPickReachPx = 6;

std::vector<LayerId> joined(std::vector<LayerId> a, std::vector<LayerId> const& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

std::vector<LayerId> toggled(std::vector<LayerId> selection, LayerId layer) {
  auto const found = std::find(selection.begin(), selection.end(), layer);
  if (found == selection.end()) return joined(std::move(selection), {layer});
  selection.erase(found);
  return selection;
}

template <typename State>
Step step_to(State state) {
  Step step;
  step.state = std::move(state);
  return step;
}

Step press_select(ToolPress const& press, ToolContext const& context) {
  auto const& pointer = press.pointer;
  auto const& view = context.view;
  auto const frame = selection_frame(context.document, view);
  auto const handle = frame ? pick_handle(*frame, view, pointer.screen) : std::nullopt;
  if (handle && *handle != FrameHandle::Inside) {
    return step_to(
        ToolTransforming{*handle, pointer, frame->box, pickable(context.document, view.selection)});
  }
  auto const depth = pointer.is_secondary ? PickDepth::Farthest : PickDepth::Nearest;
  auto const layer = pick_layer(context.document, pointer.canvas, pick_reach_px(view), depth);
  return step_to(ToolPressedOn{pointer, layer, press.clicks});
}

/// Whether a press on this place holds the selection: one of its layers lies there, be it behind others, or nothing does and it is
/// inside of the frame. So what was selected with the secondary button can be moved with the primary one.
bool is_selection_held(ToolPressedOn const& pressed, ToolContext const& context) {
  auto const& view = context.view;
  for (auto const id : pickable(context.document, view.selection)) {
    auto const* layer = find_layer(context.document, id);
    if (is_under(*layer, pressed.from.canvas, pick_reach_px(view))) return true;
  }
  if (pressed.layer != LayerId::None) return false;
  auto const frame = selection_frame(context.document, view);
  return frame && pick_handle(*frame, view, pressed.from.screen).has_value();
}

Step box_step(ToolBoxing boxing, ToolPointer const& now, Document const& document) {
  boxing.to = now.canvas;
  Rect box;
  box.include(boxing.from);
  box.include(boxing.to);
  auto selection = layers_in(document, box);
  if (now.modifiers.is_shift) selection = joined(std::move(selection), boxing.before);
  auto step = step_to(std::move(boxing));
  step.selection = std::move(selection);
  return step;
}

std::vector<Command> drag_commands(ToolTransforming const& drag, Affine const& map,
                                   Document const& document) {
  if (drag.is_copy) return duplicates(document, drag.layers, {map.e, map.f});
  if (map == Affine{}) return {};
  return {TransformLayers{drag.layers, map}};
}

/// The gesture is always the whole way from the press, so that no rounding adds up.
Step transform_step(ToolTransforming drag, ToolPointer const& now, ToolContext const& context) {
  auto const map = drag_map(drag, now);
  Step step;
  if (map) {
    step.effect = GestureEffect::Replace;
    step.commands = drag_commands(drag, *map, context.document);
  }
  step.state = std::move(drag);
  return step;
}

Step start_drag(ToolPressedOn const& pressed, ToolPointer const& now, ToolContext const& context) {
  auto const& document = context.document;
  auto const& selection = context.view.selection;
  bool const is_held = is_selection_held(pressed, context);
  if (!is_held && pressed.layer == LayerId::None) {
    return box_step({pressed.from.canvas, now.canvas, selection}, now, document);
  }
  auto next = selection;
  if (!is_held) {
    next = {pressed.layer};
    if (pressed.from.modifiers.is_shift) next = joined(std::move(next), selection);
  }
  auto const layers = pickable(document, next);
  ToolTransforming drag = {FrameHandle::Inside, pressed.from, box_of(document, layers), layers};
  drag.is_copy = pressed.from.modifiers.is_alt;
  int const first_copy = document.next_id;
  auto step = transform_step(std::move(drag), now, context);
  if (pressed.from.modifiers.is_alt) {
    next.clear();
    for (int i = 0; i < static_cast<int>(std::ssize(layers)); ++i) {
      next.push_back(LayerId{first_copy + i});
    }
  }
  if (next != selection) step.selection = std::move(next);
  return step;
}

Step clicked(ToolPressedOn const& pressed, View const& view) {
  auto step = finished();
  bool const is_shift = pressed.from.modifiers.is_shift;
  if (pressed.layer == LayerId::None) {
    if (!is_shift) step.selection = std::vector<LayerId>{};
    return step;
  }
  // Every second click: a double click right after another one takes that one back.
  if (pressed.clicks >= 2 && pressed.clicks % 2 == 0 && !is_shift) {
    step.action = pressed.from.is_secondary ? "duplicate_before" : "duplicate_behind";
    step.argument = std::to_string(static_cast<int>(pressed.layer));
    return step;
  }
  step.selection =
      is_shift ? toggled(view.selection, pressed.layer) : std::vector<LayerId>{pressed.layer};
  return step;
}

Step move_select(ToolState const& state, ToolPointer const& now, ToolContext const& context) {
  if (auto const* pressed = std::get_if<ToolPressedOn>(&state)) {
    bool const is_drag = distance(pressed->from.screen, now.screen) >= kDragThresholdPx;
    return is_drag ? start_drag(*pressed, now, context) : step_to(*pressed);
  }
  if (auto const* boxing = std::get_if<ToolBoxing>(&state)) {
    return box_step(*boxing, now, context.document);
  }
  if (auto const* drag = std::get_if<ToolTransforming>(&state)) {
    return transform_step(*drag, now, context);
  }
  return {};
}

}  // namespace

double pick_reach_px(View const& view) { return kPickReachPx / view.camera.zoom; }

Step select_step(ToolState const& state, ToolEvent const& event, ToolContext const& context) {
  if (auto const* hover = std::get_if<ToolHover>(&event)) {
    return hover_step(hover->pointer, context, pick_reach_px(context.view));
  }
  if (auto const* press = std::get_if<ToolPress>(&event)) return press_select(*press, context);
  if (auto const* move = std::get_if<ToolMove>(&event)) {
    return move_select(state, move->pointer, context);
  }
  auto step = move_select(state, std::get<ToolRelease>(event).pointer, context);
  if (auto const* pressed = std::get_if<ToolPressedOn>(&step.state)) {
    return clicked(*pressed, context.view);
  }
  step.state = ToolIdle{};
  step.is_end = true;
  return step;
}

}  // namespace inkflate
