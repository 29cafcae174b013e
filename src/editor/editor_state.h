// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/history.h"
#include "editor/actions.h"
#include "editor/engine.h"
#include "editor/model_cache.h"
#include "editor/route_pointer.h"
#include "editor/tool.h"
#include "editor/view.h"
#include "pipeline/close_document.h"
#include "pipeline/shape_previewer.h"

namespace inkflate {

/// What a gesture has made of the document so far.
struct Gesture {
  std::vector<Command> commands;
  Document document;
};

/// Everything that an engine remembers between events.
struct EditorState {
  History history{empty_document()};
  std::optional<Gesture> gesture;  // under way
  Tool gesture_tool = Tool::Brush;
  ToolState tool;
  PointerState pointers;
  View view;
  KeyMap keys;
  Language language = Language::English;
  std::string file_name = "drawing";  // without extension
  Document saved = empty_document();  // as it was saved or opened last
  long long journal_bytes = 0;        // 0: not begun
  ShapePreviewer previewer;
  ShapePreview preview;
  bool is_preview_stale = false;
  ModelCache model;
};

/// One event and what comes of it.
struct EditorTurn {
  EditorState& state;
  Changes& changes;
  Progress const& progress;
  std::string argument = {};  // of an action
};

/// With the gesture under way.
Document const& shown_document(EditorState const& state);
bool has_rough_strokes(Document const& document);
bool is_saved(EditorState const& state);

void say(EditorTurn& turn, Severity severity, Word word, std::vector<std::string> arguments = {},
         std::optional<Rect> place = {});
/// An error in words; nothing for NothingThere and Cancelled but what they say.
void say(EditorTurn& turn, Error const& error);

/// One entry of the history, written into the journal. False: the document refused it, and that was said.
bool commit(EditorTurn& turn, std::vector<Command> commands, std::string_view action);
/// The same where refusals are typed: says why there is nothing to do.
bool commit_if(EditorTurn& turn, Result<Command> const& command, std::string_view action);
bool commit_if(EditorTurn& turn, Result<std::vector<Command>> const& commands,
               std::string_view action);
/// As commit, but takes the place of the entry before when that is of the same action: a slider that is dragged is one entry.
bool commit_again(EditorTurn& turn, std::vector<Command> commands, std::string_view action);

/// What the gesture has done becomes an entry.
void end_gesture(EditorTurn& turn, std::string_view action);
/// The gesture never was.
void drop_gesture(EditorTurn& turn);

bool undo_entry(EditorTurn& turn);
bool redo_entry(EditorTurn& turn);

/// The document is another one: what is looked at follows.
void follow_document(EditorTurn& turn);

}  // namespace inkflate
