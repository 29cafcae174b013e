// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "document/history.h"
#include "editor/actions.h"
#include "editor/events.h"
#include "editor/message.h"
#include "editor/scene.h"
#include "editor/view.h"

namespace inkflate {

/// A file that the person asked for.
struct FileOut {
  std::string name;  // a proposal, with its extension
  std::vector<std::byte> bytes;
};

/// What an event has changed, and what has to be done about it outside.
struct Changes {
  bool is_scene_changed = false;  // draw again
  bool is_document_changed = false;
  bool is_state_changed = false;  // tool, mode, selection, undo, options: what surrounds the canvas
  std::vector<Message> messages = {};
  std::vector<FileOut> files = {};  // to be saved
  std::vector<std::string> studio_actions =
      {};                       // for the studio itself to do: "open", "export", "help"
  std::string journal = {};     // to be appended to the journal, and brought to the disk
  bool is_journal_new = false;  // the journal starts anew with these bytes
};

/// What surrounds the canvas shows.
struct LayerRow {
  LayerId id = LayerId::None;
  std::string name;
  double thickness = 2;
  std::optional<Colour> fill;
  bool is_hidden = false;
  bool is_locked = false;
  bool is_open = false;
  bool is_selected = false;
  std::uint64_t look = 0;  // another one when it looks different
};

struct EngineState {
  View view;
  std::vector<LayerRow> layers;  // front to back, as a list shows them
  bool has_rough_strokes = false;
  CloseChoice choice;     // of what is rough
  std::string undo_name;  // an action's; empty: nothing to undo
  std::string redo_name;
  double usual_reach = 0;  // of a bend, where the settings name none: usual_share()
  bool is_saved = true;    // nothing has changed since the last save
  std::string file_name;
  Language language = Language::English;
  std::vector<std::string> enabled;  // actions that would do something now
};

/// The whole program without a window: events in; scenes, messages and bytes out. Studios, tests and recordings drive it alike.
///
/// Any sequence of events is allowed. It holds no clock, opens no file, and works on the caller's thread; progress is told and asked
/// during long work.
class Engine {
 public:
  explicit Engine(Progress progress = {});
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  Changes handle(Event const& event);

  /// Work put off so that events are answered at once: the preview of the shape, the model, what the Deform tool needs. To be called when no event waits.
  bool has_work() const;
  Changes work();

  /// Goes on from a journal that an earlier run has left.
  /// file_name: what the drawing was called, without extension, which no journal knows; empty: as a new one
  Changes recover(std::span<std::byte const> journal, std::string file_name = {});

  Scene scene();
  EngineState state() const;
  Document const& document() const;  // with the gesture under way
  History const& history() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace inkflate
