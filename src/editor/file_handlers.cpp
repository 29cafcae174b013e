// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

#include "document/merge.h"
#include "editor/action_handlers.h"
#include "editor/export_file.h"
#include "ink/trace_scan.h"
#include "io/drawing_file.h"
#include "io/read_document.h"
#include "io/read_picture.h"

namespace inkflate {
namespace {

/// "mouse" of "drawings/mouse.inkflate".
std::string stem_of(std::string const& path) {
  auto const slash = path.find_last_of("/\\");
  auto name = slash == std::string::npos ? path : path.substr(slash + 1);
  auto const dot = name.find_last_of('.');
  if (dot != std::string::npos && dot > 0) name.resize(dot);
  return name.empty() ? std::string(kNewName) : name;
}

void begin_new(EditorTurn& turn) {
  auto& state = turn.state;
  if (!is_blank(state.history.document()) &&
      !commit(turn, std::vector<Command>{Replace{empty_document()}}, "new")) {
    return;
  }
  state.saved = state.history.document();
  state.bend.forget();
  state.file_name = kNewName;
  state.view.mode = Mode::Draw;
  fit_paper(turn);
}

void save(EditorTurn& turn) {
  auto& state = turn.state;
  auto bytes = write_drawing_file(to_project(state.history.document()), DrawingFormat::Inkflate);
  if (!bytes) return say(turn, bytes.error());
  turn.changes.files.push_back({state.file_name + ".inkflate", std::move(*bytes)});
  turn.changes.is_state_changed = true;
  state.saved = state.history.document();
  say(turn, Severity::Status, Word::Saved);
}

/// The argument is an extension without its dot.
void export_as(EditorTurn& turn) {
  auto& state = turn.state;
  auto files = export_file({state.history.document(), state.view, state.file_name, turn.argument},
                           state.model, turn.progress);
  if (!files) return say(turn, files.error());
  std::move(files->begin(), files->end(), std::back_inserter(turn.changes.files));
  say(turn, Severity::Status, Word::Exported);
}

void remove_template(EditorTurn& turn) {
  commit(turn, std::vector<Command>{SetTemplate{nullptr}}, "remove_template");
}

void set_language(EditorTurn& turn) {
  if (turn.argument != "en" && turn.argument != "cs") return refuse_argument(turn);
  turn.state.language = turn.argument == "cs" ? Language::Czech : Language::English;
  turn.changes.is_state_changed = true;
}

void set_single_keys(EditorTurn& turn) {
  if (turn.argument != "on" && turn.argument != "off") return refuse_argument(turn);
  turn.state.keys.set_single_keys(turn.argument == "on" ? SingleKeys::On : SingleKeys::Off);
  turn.changes.is_state_changed = true;
}

bool has_template(EditorState const& state) {
  return state.history.document().template_picture != nullptr;
}
bool is_something_there(EditorState const& state) { return !is_blank(state.history.document()); }

constexpr std::array kHandlers = {
    ActionHandler{"new", begin_new, is_something_there},
    ActionHandler{"save", save, always},
    ActionHandler{"export_as", export_as, is_something_there},
    ActionHandler{"remove_template", remove_template, has_template},
    ActionHandler{"language", set_language, always},
    ActionHandler{"single_keys", set_single_keys, always},
};

void say_unreadable(EditorTurn& turn, Error const& error) {
  if (error.code == ErrorCode::Cancelled) return say(turn, error);
  say(turn, Severity::Problem, Word::CannotRead, {error.message});
}

void set_template(EditorTurn& turn, FileEvent const& file) {
  auto picture = read_picture(file.bytes);
  if (!picture) return say_unreadable(turn, picture.error());
  auto shared = std::make_shared<Picture const>(std::move(*picture));
  commit(turn, std::vector<Command>{SetTemplate{std::move(shared)}}, "open_template");
}

/// A scan becomes its strokes, still rough, as if they had been drawn.
Result<Document> document_of(ReadDocument read, Progress const& progress) {
  if (read.scan) {
    auto sketch = trace_scan(*read.scan, {}, progress);
    if (!sketch) return sketch.error();
    read.project.drawing.sketch = std::move(*sketch);
  }
  return make_document(read.project);
}

/// The file's document takes the place of this one, and its name.
void open_document(EditorTurn& turn, Document document, std::string const& name) {
  auto& state = turn.state;
  if (!commit(turn, std::vector<Command>{Replace{std::move(document)}}, "open")) return;
  state.saved = state.history.document();
  state.bend.forget();
  state.file_name = stem_of(name);
  state.view.mode = Mode::Draw;
  state.view.selection.clear();
  fit_paper(turn);
  say(turn, Severity::Status, Word::Opened, {state.file_name});
}

/// What is in the file comes to what is there, in front.
void add_document(EditorTurn& turn, Document const& added, std::string const& name) {
  auto const& state = turn.state;
  auto both = merged(state.history.document(), added);
  if (!commit(turn, std::vector<Command>{Replace{std::move(both)}}, "open")) return;
  say(turn, Severity::Status, Word::Opened, {stem_of(name)});
}

}  // namespace

std::span<ActionHandler const> file_handlers() { return kHandlers; }

void open_file(EditorTurn& turn, FileEvent const& file) {
  if (file.use == FileUse::Template) return set_template(turn, file);
  auto read = read_document(file.bytes);
  if (!read) return say_unreadable(turn, read.error());
  auto const warnings = read->warnings;
  auto document = document_of(*std::move(read), turn.progress);
  if (!document) return say_unreadable(turn, document.error());
  if (file.use == FileUse::Add && !is_blank(turn.state.history.document())) {
    add_document(turn, *document, file.name);
  } else {
    open_document(turn, std::move(*document), file.name);
  }
  for (auto const& warning : warnings) say(turn, Severity::Warning, Word::LeftOut, {warning});
}

}  // namespace inkflate
