// SPDX-License-Identifier: Apache-2.0
#include "editor/engine.h"

#include <utility>

#include "editor/action_handlers.h"
#include "editor/bend_gesture.h"
#include "editor/editor_state.h"
#include "editor/layer_looks.h"
#include "editor/run_tool.h"
#include "io/journal.h"

namespace inkflate {
namespace {

constexpr double kLargestViewPx = 16384;

void take_routed(EditorTurn& turn, Routed const& routed) {
  auto& [state, changes, progress, argument] = turn;
  if (auto const* const to_tool = std::get_if<ToTool>(&routed)) return run_tool(turn, *to_tool);
  if (auto const* const to_camera = std::get_if<ToCamera>(&routed)) {
    // The zoom is shown around the canvas; where the paper lies is not.
    changes.is_state_changed |= state.view.camera.zoom != to_camera->camera.zoom;
    state.view.camera = to_camera->camera;
  } else if (auto const* const to_model = std::get_if<ToModel>(&routed)) {
    state.view.model = to_model->model;
  } else if (auto const* const to_action = std::get_if<ToAction>(&routed)) {
    return run_action(turn, to_action->name, "");
  } else if (auto const* const to_reach = std::get_if<ToBendReach>(&routed)) {
    return change_bend_reach(turn, to_reach->factor);
  }
  changes.is_scene_changed = true;
}

void take_route(EditorTurn& turn, RouteStep route) {
  turn.state.pointers = std::move(route.state);
  for (auto const& routed : route.routed) take_routed(turn, routed);
}

bool is_in_gesture(EditorState const& state) {
  return state.gesture || !std::holds_alternative<ToolIdle>(state.tool);
}

/// Ends what the hand is doing as if it had never begun.
void stop_hand(EditorTurn& turn) {
  take_route(turn, drop_pointers(turn.state.pointers));
  if (is_in_gesture(turn.state)) drop_gesture(turn);
}

void take(EditorTurn& turn, PointerEvent const& event) {
  take_route(turn, route_pointer(turn.state.pointers, event, turn.state.view));
}

void take(EditorTurn& turn, WheelEvent const& event) {
  take_route(turn, route_wheel(turn.state.pointers, event, turn.state.view));
}

void take(EditorTurn& turn, GestureEvent const& event) {
  take_route(turn, route_gesture(turn.state.pointers, event, turn.state.view));
}

void take(EditorTurn& turn, ActionEvent const& event) {
  bool const goes_on = turn.state.bend.is_holding() &&
                       (event.name == "brush_larger" || event.name == "brush_smaller");
  bool const was_in_gesture = !goes_on && is_in_gesture(turn.state);
  if (was_in_gesture) stop_hand(turn);
  // Esc, undo and delete in the middle of a gesture take back just that.
  bool const is_drop = event.name == "cancel" || event.name == "undo" || event.name == "delete";
  if (was_in_gesture && is_drop) return;
  run_action(turn, event.name, event.argument);
}

void take(EditorTurn& turn, KeyEvent const& event) {
  auto& state = turn.state;
  if (event.key == " ") {
    state.pointers.is_space_held = event.is_press;
    return;
  }
  if (!event.is_press) return;
  auto const action = state.keys.action_for(event, state.view.mode);
  if (!action.empty()) take(turn, ActionEvent{std::string(action)});
}

void take(EditorTurn& turn, FileEvent const& event) {
  stop_hand(turn);
  open_file(turn, event);
}

void take(EditorTurn& turn, ResizeEvent const& event) {
  bool const is_size = event.width_px >= 1 && event.height_px >= 1 &&
                       event.width_px <= kLargestViewPx && event.height_px <= kLargestViewPx;
  if (!is_size) return;
  auto const& edges = event.edges;
  bool const are_edges = edges.left_px >= 0 && edges.top_px >= 0 && edges.right_px >= 0 &&
                         edges.bottom_px >= 0 && edges.left_px + edges.right_px <= event.width_px &&
                         edges.top_px + edges.bottom_px <= event.height_px;
  turn.state.view.size = {event.width_px, event.height_px, are_edges ? edges : ViewEdges{}};
  turn.changes.is_scene_changed = true;
}

void make_model(EditorTurn& turn) {
  auto& state = turn.state;
  auto const made = state.model.make(state.history.document(), turn.progress);
  turn.changes.is_scene_changed = true;
  if (made) return;
  state.view.mode = Mode::Draw;
  turn.changes.is_state_changed = true;
  if (made.error().code == ErrorCode::Cancelled) return say(turn, made.error());
  say(turn, Severity::Problem, Word::ModelFault, {made.error().message});
}

/// What is down was about what is no longer seen.
void follow_mode(EditorTurn& turn, Mode before) {
  if (turn.state.view.mode != before) stop_hand(turn);
}

bool is_deforming(View const& view) { return view.mode == Mode::Draw && view.tool == Tool::Deform; }

/// Rest poses and the selected pin are kept until the tool is left.
void follow_tool(EditorTurn& turn) {
  auto& state = turn.state;
  if (is_deforming(state.view)) return;
  state.bend.forget();
  state.view.pin.reset();
}

bool is_model_wanted(EditorState const& state) {
  return state.view.mode != Mode::Draw && !state.model.is_current(state.history.document());
}

LayerRow row_of(Layer const& layer, View const& view, std::uint64_t look) {
  return {layer.id,
          layer.name,
          layer.thickness,
          layer.fill,
          layer.is_hidden,
          layer.is_locked,
          layer.is_open,
          is_selected(view, layer.id),
          look};
}

}  // namespace

struct Engine::Inside {
  EditorState state;
  Progress progress;
  SceneBuilder scenes;
  LayerLooks looks;
};

Engine::Engine(Progress progress) : inside_(std::make_unique<Inside>()) {
  inside_->progress = std::move(progress);
}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

Changes Engine::handle(Event const& event) {
  Changes changes;
  EditorTurn turn = {inside_->state, changes, inside_->progress};
  auto const mode = turn.state.view.mode;
  bool const was_deforming = is_deforming(turn.state.view);
  std::visit([&](auto const& each) { take(turn, each); }, event);
  follow_mode(turn, mode);
  if (was_deforming) follow_tool(turn);
  follow_reach(turn);
  return changes;
}

bool Engine::has_work() const {
  auto const& state = inside_->state;
  return is_bend_waiting(state) || state.is_preview_stale || is_model_wanted(state) ||
         is_bend_unprepared(state);
}

Changes Engine::work() {
  Changes changes;
  auto& state = inside_->state;
  EditorTurn turn = {state, changes, inside_->progress};
  auto const mode = state.view.mode;
  // The hand first.
  if (is_bend_waiting(state)) {
    go_on_bending(turn);
  } else if (is_model_wanted(state)) {
    make_model(turn);
    follow_mode(turn, mode);
  } else if (state.is_preview_stale) {
    state.preview = state.previewer.preview(state.history.document(), inside_->progress);
    state.is_preview_stale = false;
    changes.is_scene_changed = true;
  } else if (is_bend_unprepared(state)) {
    prepare_bend(state);
    follow_reach(turn);
  }
  return changes;
}

Changes Engine::recover(std::span<std::byte const> journal, std::string file_name) {
  Changes changes;
  auto& state = inside_->state;
  EditorTurn turn = {state, changes, inside_->progress};
  auto read = read_journal(journal);
  if (!read) {
    say(turn, Severity::Problem, Word::CannotRead, {read.error().message});
    return changes;
  }
  stop_hand(turn);
  state.journal.resume(*read);
  state.slider.reset();
  state.bend.forget();
  state.history = std::move(read->history);
  state.saved = empty_document();
  state.file_name = file_name.empty() ? std::string(kNewName) : std::move(file_name);
  state.view.selection.clear();
  // What was whole goes on as the new journal; what was torn is gone for good.
  for (auto const byte : journal.first(read->bytes)) {
    changes.journal.push_back(static_cast<char>(byte));
  }
  changes.is_journal_new = true;
  follow_document(turn);
  fit_paper(turn);
  if (read->is_damaged) {
    say(turn, Severity::Warning, Word::RecoveredInPart);
  } else {
    say(turn, Severity::Status, Word::Recovered);
  }
  return changes;
}

Scene Engine::scene() {
  auto const& state = inside_->state;
  bool const has_model = state.view.mode != Mode::Draw;
  return inside_->scenes.build(
      {shown_document(state), state.view, state.tool, state.preview,
       has_model ? state.model.scene(state.view.model, state.view.shading) : std::nullopt});
}

EngineState Engine::state() const {
  auto const& state = inside_->state;
  auto const& document = shown_document(state);
  EngineState result;
  result.view = state.view;
  auto const& layers = *document.layers;
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    result.layers.push_back(row_of((*layer)->layer, state.view, inside_->looks.look(*layer)));
  }
  inside_->looks.keep_only(document);
  result.has_rough_strokes = has_rough_strokes(document);
  result.choice = *document.choice;
  result.undo_name = action_name(state.history.undo_label());
  result.redo_name = action_name(state.history.redo_label());
  result.is_saved = is_saved(state);
  result.usual_reach = state.usual_reach;
  result.file_name = state.file_name;
  result.language = state.language;
  for (auto const& action : actions()) {
    auto const* const handler = find_handler(action.name);
    if (handler == nullptr || handler->is_enabled(state)) {
      result.enabled.emplace_back(action.name);
    }
  }
  return result;
}

Document const& Engine::document() const { return shown_document(inside_->state); }
History const& Engine::history() const { return inside_->state.history; }

}  // namespace inkflate
