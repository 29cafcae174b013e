// SPDX-License-Identifier: Apache-2.0
#include <emscripten.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "editor/document_picture.h"
#include "editor/engine.h"
#include "io/write_png.h"
#include "web/bindings/changes_answer.h"
#include "web/bindings/scene_answer.h"
#include "web/bindings/state_answer.h"
#include "web/bindings/work_share.h"

// The border between the core and src/worker/engine.ts: plain functions around one engine. Numbers go in as they are; texts and
// files as bytes in memory that the caller has taken with malloc. Choices are numbers, in the order of the enums and of the lists in
// src/protocol/events.ts. What comes out is an Answer, in memory until the next call.

// Not a function of ours: the page's, called in the midst of long work.
EM_JS(void, tell_progress, (char const* stage, int length, double share),
      { Module["onProgress"](UTF8ToString(stage, length), share); });

namespace inkflate::web {
namespace {

/// Where the parts of an answer lie, for the other side to read as four numbers.
struct AnswerPlace {
  std::uint32_t head = 0;
  std::uint32_t head_bytes = 0;
  std::uint32_t blobs = 0;
  std::uint32_t blob_bytes = 0;
};

std::uint32_t address(void const* data) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(data));
}

constexpr unsigned kShift = 1;
constexpr unsigned kCtrl = 2;
constexpr unsigned kAlt = 4;

Modifiers modifiers_of(unsigned bits) {
  return {(bits & kShift) != 0, (bits & kCtrl) != 0, (bits & kAlt) != 0};
}

}  // namespace

/// The engine and what of it is on its way out.
class Core {
 public:
  Core() : engine_(Progress{[this](std::string_view stage) { tell(stage); }, {}}) {}

  void handle(Event const& event) {
    share_.start();
    gather(changes_, engine_.handle(event));
  }
  bool has_work() const { return engine_.has_work(); }
  void work() {
    share_.start();
    gather(changes_, engine_.work());
  }
  void recover(std::span<std::byte const> journal, std::string file_name) {
    auto recovered = engine_.recover(journal, std::move(file_name));
    recovery_ = recovery_of(recovered, journal.size());
    gather(changes_, std::move(recovered));
  }

  AnswerPlace const* take_changes() {
    auto const language = engine_.state().language;
    return out(changes_answer(std::exchange(changes_, {}), recovery_, language));
  }
  AnswerPlace const* scene() { return out(scenes_.answer(engine_.scene())); }
  AnswerPlace const* state() { return out(state_answer(engine_.state(), engine_.document())); }
  AnswerPlace const* actions() { return out(actions_answer()); }

  AnswerPlace const* thumbnail(LayerId id, int side_px) {
    auto const* const layer = find_layer(engine_.document(), id);
    if (layer == nullptr) return nullptr;
    auto const picture = picture_of_layer(*layer, side_px);
    BlobWriter blobs;
    auto const pixels = blobs.add(std::as_bytes(std::span(picture.values)));
    return out(
        blobs.answer({{"width", picture.width}, {"height", picture.height}, {"pixels", pixels}}));
  }

  AnswerPlace const* picture(int side_px) {
    if (is_blank(engine_.document())) return nullptr;
    BlobWriter blobs;
    auto const png = blobs.add(write_png(picture_of_document(engine_.document(), side_px)));
    return out(blobs.answer({{"png", png}}));
  }

 private:
  void tell(std::string_view stage) {
    tell_progress(stage.data(), static_cast<int>(stage.size()), share_.enter(stage));
  }

  AnswerPlace const* out(Answer answer) {
    answer_ = std::move(answer);
    place_ = {address(answer_.head.data()), static_cast<std::uint32_t>(answer_.head.size()),
              address(answer_.blobs.data()), static_cast<std::uint32_t>(answer_.blobs.size())};
    return &place_;
  }

  WorkShare share_;
  Engine engine_;
  SceneSender scenes_;
  Changes changes_;
  Recovery recovery_ = Recovery::Whole;
  Answer answer_;
  AnswerPlace place_;
};

namespace {

std::string text_at(char const* text, std::size_t bytes) { return {text, bytes}; }

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE Core* engine_new() { return new Core; }
EMSCRIPTEN_KEEPALIVE void engine_delete(Core* core) { delete core; }

EMSCRIPTEN_KEEPALIVE void engine_pointer(Core* core, PointerAction action, PointerKind kind, int id,
                                         PointerButton button, double x, double y, double pressure,
                                         double time_s, unsigned modifiers) {
  core->handle(
      PointerEvent{action, kind, id, button, {x, y}, pressure, time_s, modifiers_of(modifiers)});
}
EMSCRIPTEN_KEEPALIVE void engine_key(Core* core, char const* key, std::size_t key_bytes,
                                     bool is_press, bool is_repeat, double time_s,
                                     unsigned modifiers) {
  core->handle(
      KeyEvent{text_at(key, key_bytes), is_press, is_repeat, time_s, modifiers_of(modifiers)});
}
EMSCRIPTEN_KEEPALIVE void engine_wheel(Core* core, double x, double y, double delta_x,
                                       double delta_y, unsigned modifiers) {
  core->handle(WheelEvent{{x, y}, {delta_x, delta_y}, modifiers_of(modifiers)});
}
EMSCRIPTEN_KEEPALIVE void engine_gesture(Core* core, double x, double y, double scale,
                                         double moved_x, double moved_y) {
  core->handle(GestureEvent{{x, y}, scale, {moved_x, moved_y}});
}
EMSCRIPTEN_KEEPALIVE void engine_action(Core* core, char const* name, std::size_t name_bytes,
                                        char const* argument, std::size_t argument_bytes) {
  core->handle(ActionEvent{text_at(name, name_bytes), text_at(argument, argument_bytes)});
}
EMSCRIPTEN_KEEPALIVE void engine_file(Core* core, std::byte const* bytes, std::size_t count,
                                      char const* name, std::size_t name_bytes, FileUse use) {
  core->handle(FileEvent{{bytes, bytes + count}, text_at(name, name_bytes), use});
}
EMSCRIPTEN_KEEPALIVE void engine_resize(Core* core, double width_px, double height_px,
                                        double left_px, double top_px, double right_px,
                                        double bottom_px) {
  core->handle(ResizeEvent{width_px, height_px, {left_px, top_px, right_px, bottom_px}});
}

EMSCRIPTEN_KEEPALIVE bool engine_has_work(Core const* core) { return core->has_work(); }
EMSCRIPTEN_KEEPALIVE void engine_work(Core* core) { core->work(); }
EMSCRIPTEN_KEEPALIVE void engine_recover(Core* core, std::byte const* journal, std::size_t bytes,
                                         char const* name, std::size_t name_bytes) {
  core->recover({journal, bytes}, text_at(name, name_bytes));
}

// Answers; null: there is nothing to answer.
EMSCRIPTEN_KEEPALIVE AnswerPlace const* engine_take_changes(Core* core) {
  return core->take_changes();
}
EMSCRIPTEN_KEEPALIVE AnswerPlace const* engine_scene(Core* core) { return core->scene(); }
EMSCRIPTEN_KEEPALIVE AnswerPlace const* engine_state(Core* core) { return core->state(); }
EMSCRIPTEN_KEEPALIVE AnswerPlace const* engine_actions(Core* core) { return core->actions(); }
EMSCRIPTEN_KEEPALIVE AnswerPlace const* engine_thumbnail(Core* core, LayerId layer, int side_px) {
  return core->thumbnail(layer, side_px);
}
EMSCRIPTEN_KEEPALIVE AnswerPlace const* engine_picture(Core* core, int side_px) {
  return core->picture(side_px);
}

}  // extern "C"

}  // namespace inkflate::web
