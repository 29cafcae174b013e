// SPDX-License-Identifier: Apache-2.0
#include "editor/editor_state.h"

#include <algorithm>
#include <utility>

#include "document/apply.h"
#include "io/journal.h"

namespace inkflate {
namespace {

/// A journal longer than this begins anew with the document as it is: reading it back would take too long.
constexpr long long kLongestJournalBytes = 32LL << 20U;

/// Pointers alone tell: documents between which nothing was done share everything.
bool is_same(Document const& a, Document const& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.groups == b.groups &&
         a.loose.is_same(b.loose) && a.choice == b.choice && a.layers == b.layers &&
         a.template_picture == b.template_picture && a.pins == b.pins && a.clip == b.clip;
}

void write_journal(Turn& turn, JournalEntry const& entry) {
  auto& [state, changes, progress, argument] = turn;
  auto line = journal_line(entry);
  if (state.journal_bytes == 0 || state.journal_bytes + std::ssize(line) > kLongestJournalBytes) {
    bool const is_first = state.journal_bytes == 0;
    changes.is_journal_new = true;
    changes.journal = journal_start();
    // A long journal goes on from the document as it is now, after this entry.
    if (!is_first) line = journal_line(JournalDo{{Replace{state.history.document()}}});
    state.journal_bytes = std::ssize(changes.journal);
  }
  changes.journal += line;
  state.journal_bytes += std::ssize(line);
}

}  // namespace

Document const& shown_document(EditorState const& state) {
  return state.gesture ? state.gesture->document : state.history.document();
}

bool has_rough_strokes(Document const& document) {
  auto const is_open = [](auto const& layer) { return layer->layer.is_open; };
  return !document.loose.is_empty() ||
         std::any_of(document.layers->begin(), document.layers->end(), is_open);
}

bool is_saved(EditorState const& state) {
  return !state.gesture && is_same(state.history.document(), state.saved);
}

void say(Turn& turn, Severity severity, Word word, std::vector<std::string> arguments,
         std::optional<Rect> place) {
  turn.changes.messages.push_back({severity, word, std::move(arguments), place});
}

void say(Turn& turn, Error const& error) {
  if (error.code == ErrorCode::Cancelled) return say(turn, Severity::Status, Word::Cancelled);
  say(turn, Severity::Problem, Word::CannotDo, {error.message});
}

bool commit(Turn& turn, std::vector<Command> commands, std::string_view action) {
  auto& state = turn.state;
  int const label = action_index(action);
  auto const done = state.history.push(commands, label);
  if (!done) {
    say(turn, done.error());
    return false;
  }
  write_journal(turn, JournalDo{std::move(commands), label});
  follow_document(turn);
  return true;
}

bool commit_if(Turn& turn, Result<std::vector<Command>> const& commands, std::string_view action) {
  if (commands) return commit(turn, *commands, action);
  say(turn, commands.error());
  return false;
}

bool commit_if(Turn& turn, Result<Command> const& command, std::string_view action) {
  if (command) return commit(turn, std::vector<Command>{*command}, action);
  say(turn, command.error());
  return false;
}

bool commit_again(Turn& turn, std::vector<Command> commands, std::string_view action) {
  auto& history = turn.state.history;
  bool const is_same_action =
      history.can_undo() && !history.can_redo() && history.undo_label() == action_index(action);
  // Tried first, so that a refused value leaves the entry before as it is.
  if (is_same_action && inkflate::apply(history.document(), commands)) undo_entry(turn);
  return commit(turn, std::move(commands), action);
}

void end_gesture(Turn& turn, std::string_view action) {
  auto& state = turn.state;
  auto gesture = std::exchange(state.gesture, std::nullopt);
  if (!gesture || gesture->commands.empty()) return;
  int const label = action_index(action);
  state.history.push(std::move(gesture->document), label);
  write_journal(turn, JournalDo{std::move(gesture->commands), label});
  follow_document(turn);
}

void drop_gesture(Turn& turn) {
  auto& state = turn.state;
  bool const had_changes = state.gesture && !state.gesture->commands.empty();
  state.gesture.reset();
  state.tool = ToolIdle{};
  turn.changes.is_scene_changed = true;
  if (had_changes) follow_document(turn);
}

bool undo_entry(Turn& turn) {
  if (!turn.state.history.undo()) return false;
  write_journal(turn, JournalUndo{});
  follow_document(turn);
  return true;
}

bool redo_entry(Turn& turn) {
  if (!turn.state.history.redo()) return false;
  write_journal(turn, JournalRedo{});
  follow_document(turn);
  return true;
}

void follow_document(Turn& turn) {
  auto& [state, changes, progress, argument] = turn;
  auto const& document = state.history.document();
  std::erase_if(state.view.selection, [&](LayerId id) {
    auto const* const layer = find_layer(document, id);
    return layer == nullptr || layer->layer.is_hidden;
  });
  if (find_layer(document, state.view.hover) == nullptr) state.view.hover = LayerId::None;
  state.is_preview_stale = has_rough_strokes(document);
  if (!state.is_preview_stale) state.preview = {};
  changes.is_document_changed = changes.is_scene_changed = changes.is_state_changed = true;
}

}  // namespace inkflate
