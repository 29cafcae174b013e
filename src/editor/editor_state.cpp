// SPDX-License-Identifier: Apache-2.0
#include "editor/editor_state.h"

#include <algorithm>
#include <utility>

#include "document/apply.h"
#include "editor/bend_gesture.h"
#include "editor/pins.h"

namespace inkflate {
namespace {

/// Pointers alone tell: documents between which nothing was done share everything.
bool is_same(Document const& a, Document const& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.groups == b.groups &&
         a.loose.is_same(b.loose) && a.choice == b.choice && a.layers == b.layers &&
         a.template_picture == b.template_picture && a.pins == b.pins && a.clip == b.clip;
}

/// The history has just taken a step: the journal takes it as well, and what is looked at follows.
void take_entry(EditorTurn& turn, JournalEntry const& entry) {
  auto& state = turn.state;
  state.slider.reset();
  auto written = state.journal.add(entry, state.history);
  if (written.is_new) {
    turn.changes.is_journal_new = true;
    turn.changes.journal.clear();
  }
  turn.changes.journal += written.text;
  follow_document(turn);
}

bool goes_on(EditorState const& state, std::string_view action,
             std::vector<LayerId> const& layers) {
  return state.slider && state.slider->action == action && state.slider->layers == layers;
}

}  // namespace

Document const& shown_document(EditorState const& state) {
  return state.gesture ? state.gesture->document : state.history.document();
}

bool has_rough_strokes(Document const& document) {
  auto const is_rough = [](Shared<DocumentLayer> const& layer) {
    return takes_strokes(layer->layer) && !layer->strokes.is_empty();
  };
  return !document.loose.is_empty() ||
         std::any_of(document.layers->begin(), document.layers->end(), is_rough);
}

bool is_saved(EditorState const& state) {
  return !state.gesture && is_same(state.history.document(), state.saved);
}

void say(EditorTurn& turn, Severity severity, Word word, std::vector<std::string> arguments,
         std::optional<Rect> place) {
  turn.changes.messages.push_back({severity, word, std::move(arguments), place});
}

void say(EditorTurn& turn, Error const& error) {
  if (error.code == ErrorCode::Cancelled) return say(turn, Severity::Status, Word::Cancelled);
  bool const is_idle = error.code == ErrorCode::NothingThere;
  say(turn, is_idle ? Severity::Warning : Severity::Problem, Word::CannotDo, {error.message});
}

bool commit(EditorTurn& turn, std::vector<Command> commands, std::string_view action) {
  auto& state = turn.state;
  int const label = action_index(action);
  auto const done = state.history.push(commands, label);
  if (!done) {
    say(turn, done.error());
    return false;
  }
  take_entry(turn, JournalDo{std::move(commands), label});
  return true;
}

bool commit_if(EditorTurn& turn, Result<std::vector<Command>> const& commands,
               std::string_view action) {
  if (commands) return commit(turn, *commands, action);
  say(turn, commands.error());
  return false;
}

bool commit_if(EditorTurn& turn, Result<Command> const& command, std::string_view action) {
  if (command) return commit(turn, std::vector<Command>{*command}, action);
  say(turn, command.error());
  return false;
}

Document const& slider_base(EditorState const& state, std::string_view action,
                            std::vector<LayerId> const& layers) {
  return goes_on(state, action, layers) ? state.slider->before : state.history.document();
}

bool commit_value(EditorTurn& turn, std::vector<Command> commands, std::string_view action,
                  std::vector<LayerId> const& layers) {
  auto& state = turn.state;
  bool const is_next = goes_on(state, action, layers);
  Document const before = slider_base(state, action, layers);
  // Tried first, so that a refused value leaves the entry before as it is.
  auto const tried = inkflate::apply(before, commands);
  bool const is_back = !tried && is_next && tried.error().code == ErrorCode::NothingThere;
  if (!tried && !is_back) {
    say(turn, tried.error());
    return false;
  }
  if (is_next) undo_entry(turn);
  if (is_back) return true;
  if (!commit(turn, std::move(commands), action)) return false;
  state.slider = {action, layers, before};
  return true;
}

std::vector<Command> without_idle(Document const& document, std::vector<Command> const& commands) {
  std::vector<Command> result;
  auto now = document;
  for (auto const& command : commands) {
    auto next = inkflate::apply(now, command);
    if (!next && next.error().code == ErrorCode::NothingThere) continue;
    if (next) now = *std::move(next);
    result.push_back(command);
  }
  return result.empty() ? commands : result;
}

void end_gesture(EditorTurn& turn, std::string_view action) {
  auto& state = turn.state;
  auto gesture = std::exchange(state.gesture, std::nullopt);
  if (!gesture || gesture->commands.empty()) return;
  int const label = action_index(action);
  state.history.push(std::move(gesture->document), label);
  take_entry(turn, JournalDo{std::move(gesture->commands), label});
}

void drop_gesture(EditorTurn& turn) {
  auto& state = turn.state;
  bool const had_changes = state.gesture && !state.gesture->commands.empty();
  state.gesture.reset();
  drop_bend(state);
  state.tool = ToolIdle{};
  turn.changes.is_scene_changed = true;
  if (had_changes) follow_document(turn);
}

bool undo_entry(EditorTurn& turn) {
  if (!turn.state.history.undo()) return false;
  take_entry(turn, JournalUndo{});
  return true;
}

bool redo_entry(EditorTurn& turn) {
  if (!turn.state.history.redo()) return false;
  take_entry(turn, JournalRedo{});
  return true;
}

void set_selection(EditorTurn& turn, std::vector<LayerId> layers) {
  auto const& document = shown_document(turn.state);
  std::erase_if(layers, [&](LayerId id) {
    auto const* const layer = find_layer(document, id);
    return layer == nullptr || layer->layer.is_hidden;
  });
  std::sort(layers.begin(), layers.end());
  layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
  auto& selection = turn.state.view.selection;
  if (layers == selection) return;
  selection = std::move(layers);
  turn.changes.is_scene_changed = turn.changes.is_state_changed = true;
}

void follow_document(EditorTurn& turn) {
  auto& state = turn.state;
  auto& changes = turn.changes;
  auto const& document = state.history.document();
  set_selection(turn, state.view.selection);
  if (find_layer(document, state.view.hover) == nullptr) state.view.hover = LayerId::None;
  auto& pin = state.view.pin;
  if (pin && find_pin(document, *pin) == nullptr) pin.reset();
  state.is_preview_stale = has_rough_strokes(document);
  if (!state.is_preview_stale) state.preview = {};
  changes.is_document_changed = changes.is_scene_changed = changes.is_state_changed = true;
}

}  // namespace inkflate
