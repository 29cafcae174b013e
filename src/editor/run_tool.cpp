// SPDX-License-Identifier: Apache-2.0
#include "editor/run_tool.h"

#include <algorithm>
#include <string>
#include <utility>

#include "document/apply.h"
#include "editor/action_handlers.h"
#include "editor/bend_gesture.h"
#include "editor/pick.h"

namespace inkflate {
namespace {

/// Under which action the gestures of a tool are undone.
std::string_view action_of(Tool tool) {
  switch (tool) {
    case Tool::Brush:
      return "brush";
    case Tool::HelpLine:
      return "help_line";
    case Tool::Eraser:
      return "eraser";
    case Tool::Mark:
      return "mark";
    case Tool::Deform:
      return "deform";
    case Tool::Select:
      return "select_tool";
    case Tool::Hand:
      break;
  }
  return "hand";
}

/// Puts the commands of a step into the gesture. One that the document refuses leaves the gesture as it was.
void change_gesture(EditorTurn& turn, Step& step) {
  auto& state = turn.state;
  if (step.effect == GestureEffect::None) return;
  if (step.effect == GestureEffect::Replace && step.commands.empty()) {
    state.gesture.reset();
    drop_bend(state);
    turn.changes.is_scene_changed = true;
    return;
  }
  bool const is_new = step.effect == GestureEffect::Replace || !state.gesture;
  auto const& base = is_new ? state.history.document() : state.gesture->document;
  auto next = inkflate::apply(base, step.commands);
  turn.changes.is_scene_changed = true;
  if (!next) {
    if (step.is_end && next.error().code != ErrorCode::NothingThere) say(turn, next.error());
    return;
  }
  if (is_new) {
    state.gesture = Gesture{std::move(step.commands), std::move(*next)};
    return;
  }
  state.gesture->document = std::move(*next);
  for (auto& command : step.commands) state.gesture->commands.push_back(std::move(command));
}

void set_pin(EditorTurn& turn, std::optional<BendPinRef> const& pin) {
  if (turn.state.view.pin == pin) return;
  turn.state.view.pin = pin;
  turn.changes.is_scene_changed = turn.changes.is_state_changed = true;
}

void take_step(EditorTurn& turn, Tool tool, Step step) {
  auto& [state, changes, progress, argument] = turn;
  state.tool = std::move(step.state);
  change_gesture(turn, step);
  if (step.bend) bend_towards(turn, *step.bend);
  if (step.is_end) finish_bend(turn);
  if (step.is_end) end_gesture(turn, action_of(tool));
  if (step.word) say(turn, Severity::Warning, *step.word);
  if (step.pin) set_pin(turn, *step.pin);
  if (step.selection) set_selection(turn, *std::move(step.selection));
  if (step.hover && *step.hover != state.view.hover) {
    state.view.hover = *step.hover;
    changes.is_scene_changed = changes.is_state_changed = true;
  }
  if (step.camera) state.view.camera = *step.camera;
  bool const is_seen = step.camera || !std::holds_alternative<ToolIdle>(state.tool) || step.is_end;
  if (is_seen) changes.is_scene_changed = true;
  if (!step.action.empty()) run_action(turn, step.action, step.argument);
}

/// Whether a dot is all that is rough, and the last that was done.
bool is_dot_alone(EditorState const& state) {
  auto const& document = state.history.document();
  auto const& layers = *document.layers;
  bool const is_other_rough = std::any_of(
      layers.begin(), layers.end(), [](auto const& layer) { return takes_strokes(layer->layer); });
  return !is_other_rough && document.loose.size() == 1 &&
         document.loose[0]->stroke.samples.size() == 1 &&
         action_name(state.history.undo_label()) == action_of(Tool::Brush);
}

/// A double click with the brush means the part under it, as long as nothing else is being drawn: the dot of the first click is taken back
/// and the part gets its copy.
bool take_double_click(EditorTurn& turn, Tool tool, ToolEvent const& event) {
  auto& state = turn.state;
  auto const* const press = std::get_if<ToolPress>(&event);
  bool const is_double = press != nullptr && press->clicks == 2 && tool == Tool::Brush;
  auto const& document = state.history.document();
  if (!is_double || !is_dot_alone(state)) return false;
  bool const is_far = press->pointer.is_secondary;
  auto const layer = pick_layer(document, press->pointer.canvas, 0,
                                is_far ? PickDepth::Farthest : PickDepth::Nearest);
  if (layer == LayerId::None || !undo_entry(turn)) return false;
  state.pointers = drop_pointers(state.pointers).state;
  run_action(turn, is_far ? "duplicate_before" : "duplicate_behind",
             std::to_string(static_cast<int>(layer)));
  return true;
}

}  // namespace

void run_tool(EditorTurn& turn, ToTool const& routed) {
  auto& state = turn.state;
  if (take_double_click(turn, routed.tool, routed.event)) return;
  // Both are moved, or each sample would copy the line so far.
  take_step(turn, routed.tool,
            tool_step(routed.tool, std::move(state.tool), routed.event,
                      {shown_document(state), state.view}));
}

}  // namespace inkflate
