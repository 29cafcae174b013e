// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/history.h"
#include "editor/actions.h"
#include "editor/bend_reach.h"
#include "editor/engine.h"
#include "editor/journal_keeper.h"
#include "editor/model_cache.h"
#include "editor/route_pointer.h"
#include "editor/tool.h"
#include "editor/view.h"
#include "pipeline/bend_session.h"
#include "pipeline/close_document.h"
#include "pipeline/shape_previewer.h"

namespace inkflate {

/// What a drawing is called that no file has named.
inline constexpr std::string_view kNewName = "drawing";

/// What a gesture has made of the document so far.
struct Gesture {
  std::vector<Command> commands;
  Document document;
};

/// The last entry, as long as nothing else was done: more values of the same slider may take its place.
struct Slider {
  std::string_view action;
  std::vector<LayerId> layers;  // that it changes
  Document before;              // the entry
};

/// Everything that an engine remembers between events.
struct EditorState {
  History history{empty_document()};
  std::optional<Gesture> gesture;  // under way
  std::optional<Slider> slider;
  ToolState tool;
  BendSession bend;                      // rest poses, and the drag of the Deform tool
  std::optional<ToolBending> bend_hand;  // where it is, as long as the session has not followed it
  double usual_reach = usual_bend_reach(BendMode::Body);  // of a bend, where the settings name none
  PointerState pointers;
  View view;
  KeyMap keys;
  Language language = Language::English;
  std::string file_name{kNewName};      // without extension
  Document saved = history.document();  // as it was saved or opened last
  JournalKeeper journal;
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
/// An error in words.
void say(EditorTurn& turn, Error const& error);

/// One entry of the history, written into the journal. False: the document refused it, and that was said.
bool commit(EditorTurn& turn, std::vector<Command> commands, std::string_view action);
/// The same where refusals are typed: says why there is nothing to do.
bool commit_if(EditorTurn& turn, Result<Command> const& command, std::string_view action);
bool commit_if(EditorTurn& turn, Result<std::vector<Command>> const& commands,
               std::string_view action);

/// The document that a slider's next value changes: as it was before the entry that the value goes on with, or as it is.
Document const& slider_base(EditorState const& state, std::string_view action,
                            std::vector<LayerId> const& layers);
/// As commit, for a value of a slider that changes these layers: a slider that is dragged is one entry, and none when it comes back to
/// where it was.
///
/// in      commands: for slider_base()
bool commit_value(EditorTurn& turn, std::vector<Command> commands, std::string_view action,
                  std::vector<LayerId> const& layers);

/// The commands without those that would change nothing; all of them when none would change anything. So that layers that are already
/// as all of the selected shall be do not stand in the way.
std::vector<Command> without_idle(Document const& document, std::vector<Command> const& commands);

/// What the gesture has done becomes an entry.
void end_gesture(EditorTurn& turn, std::string_view action);
/// The gesture never was.
void drop_gesture(EditorTurn& turn);

bool undo_entry(EditorTurn& turn);
bool redo_entry(EditorTurn& turn);

/// Selects those of the layers that exist, with the gesture under way, and are not hidden.
void set_selection(EditorTurn& turn, std::vector<LayerId> layers);

/// The document is another one: what is looked at follows.
void follow_document(EditorTurn& turn);

}  // namespace inkflate
