// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "bytes.h"
#include "editor/engine.h"
#include "io/document_hash.h"
#include "io/read_document_json.h"
#include "io/write_document_json.h"

namespace inkflate {
namespace {

constexpr int kMostEvents = 48;
constexpr int kMostPresses = 8;  // each may be a stroke, and strokes are what takes time

constexpr std::array<char const*, 33> kKeys = {
    "b", "l", "e",        "v",      "o",   "h", "m", "Enter", "Escape", "Delete",  "PageUp",
    "z", "y", "PageDown", "Insert", "End", "H", "V", " ",     "1",      "2",       "a",
    "d", "d", "D",        "n",      "N",   ",", ".", "[",     "]",      "ArrowUp", "ArrowLeft"};

constexpr std::array<char const*, 16> kArguments = {
    "",      "0",  "-1", "3",     "1e300", "nan", "#ff8040", "100,200",
    "inf,0", "on", "cs", "whole", "wire",  "0.1", "auto",    "\xff\xfe"};

constexpr char const* kSketch =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200" fill="none" stroke="black">
<g id="a"><path d="M50 50H150V150H50Z"/></g><path d="M200 50H250V150H210"/></svg>)";

/// Mostly something that a person could do, so that there is something to go wrong with.
class EventSource {
 public:
  explicit EventSource(Bytes& bytes) : bytes_(bytes) {}

  Event next() {
    switch (bytes_.below(12)) {
      case 0:
      case 1:
        return key();
      case 2:
        return action();
      case 3:
        return WheelEvent{place(), place(), modifiers()};
      case 4:
        return GestureEvent{place(), number(4), place()};
      case 5:
        return bytes_.below(4) == 0 ? Event{ResizeEvent{number(1500), number(1500)}} : key();
      case 6:
        return bytes_.below(4) == 0 ? Event{file()} : Event{action()};
      default:
        return pointer();
    }
  }

 private:
  double number(double most) {
    int const kind = bytes_.byte();
    if (kind == 0) return std::numeric_limits<double>::quiet_NaN();
    if (kind == 1) return std::numeric_limits<double>::infinity();
    if (kind == 2) return bytes_.number();
    return bytes_.share() * most;
  }

  Vec2 place() {
    double const x = number(1000);
    return {x, number(1000)};
  }

  Modifiers modifiers() {
    int const bits = bytes_.byte();
    // Mostly none are held.
    if (bits >= 32) return {};
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
  }

  PointerEvent pointer() {
    PointerEvent event;
    // Rather a release for each press; some are lost all the same.
    int const action = bytes_.below(8);
    event.action = action < 2                            ? PointerAction::Press
                   : action < 5                          ? PointerAction::Move
                   : action == 7 && bytes_.below(4) == 0 ? PointerAction::Cancel
                                                         : PointerAction::Release;
    if (event.action == PointerAction::Press && ++presses_ > kMostPresses) {
      event.action = PointerAction::Release;
    }
    int const kind = bytes_.below(8);
    event.kind = kind < 4 ? PointerKind::Mouse : kind < 6 ? PointerKind::Pen : PointerKind::Touch;
    event.id = kind % 3;
    constexpr std::array<PointerButton, 8> buttons = {
        PointerButton::Primary,   PointerButton::Primary, PointerButton::Primary,
        PointerButton::Primary,   PointerButton::None,    PointerButton::Middle,
        PointerButton::Secondary, PointerButton::Eraser};
    event.button = buttons[static_cast<std::size_t>(bytes_.below(8))];
    event.screen = place();
    event.pressure = number(1);
    time_s_ += bytes_.share() - 0.1;
    event.time_s = bytes_.below(40) == 0 ? number(10) : time_s_;
    event.modifiers = modifiers();
    return event;
  }

  KeyEvent key() {
    KeyEvent event;
    event.key = kKeys[static_cast<std::size_t>(bytes_.below(static_cast<int>(kKeys.size())))];
    event.is_press = bytes_.below(8) != 0;
    event.is_repeat = bytes_.below(8) == 0;
    event.time_s = time_s_;
    event.modifiers = modifiers();
    if (event.key == "z" || event.key == "y") event.modifiers.is_ctrl = true;
    return event;
  }

  ActionEvent action() {
    auto const all = actions();
    auto const index = static_cast<std::size_t>(bytes_.below(static_cast<int>(all.size()) + 1));
    std::string const name = index < all.size() ? std::string(all[index].name) : "no such action";
    return {
        name,
        kArguments[static_cast<std::size_t>(bytes_.below(static_cast<int>(kArguments.size())))]};
  }

  FileEvent file() {
    std::string text = kSketch;
    // A torn one now and then.
    if (bytes_.below(4) == 0) text.resize(static_cast<std::size_t>(bytes_.byte()));
    auto const content = std::as_bytes(std::span(text.data(), text.size()));
    constexpr std::array<FileUse, 3> uses = {FileUse::Open, FileUse::Add, FileUse::Template};
    return {{content.begin(), content.end()},
            "fuzz.svg",
            uses[static_cast<std::size_t>(bytes_.below(3))]};
  }

  Bytes& bytes_;
  int presses_ = 0;
  double time_s_ = 0;
};

/// A part that can be bent, and the tool for it.
void begin_bending(Engine& engine) {
  std::string_view const text = kSketch;
  auto const content = std::as_bytes(std::span(text.data(), text.size()));
  engine.handle(FileEvent{{content.begin(), content.end()}, "fuzz.svg", FileUse::Open});
  engine.handle(ActionEvent{"simplify"});
  engine.handle(ActionEvent{"deform"});
}

std::uint64_t hash_of(Engine const& engine) {
  return document_hash(to_project(engine.history().document()));
}

void check_document(Document const& document) {
  auto project = to_project(document);
  auto const again = make_document(project);
  CHECK(again.has_value(), "a document's project is a document");
  CHECK(to_project(*again) == project, "and the same one");
  project.template_picture.reset();  // lies beside the document
  auto const read = read_document_json(write_document_json(project));
  CHECK(read.has_value() && read->project == project, "a document reads as it was written");
}

/// All the way back and forth again.
void check_history(Engine& engine) {
  engine.handle(ActionEvent{"cancel"});
  engine.handle(ActionEvent{"mode_draw"});
  auto const last = hash_of(engine);
  int const position = engine.history().position();
  std::vector<std::uint64_t> hashes;
  while (engine.history().can_undo()) {
    hashes.push_back(hash_of(engine));
    int const before = engine.history().position();
    engine.handle(ActionEvent{"undo"});
    CHECK(engine.history().position() == before - 1, "undo takes back one entry");
  }
  while (engine.history().position() < position) {
    engine.handle(ActionEvent{"redo"});
    CHECK(hash_of(engine) == hashes.back(), "redo leads to what undo left");
    hashes.pop_back();
  }
  CHECK(hash_of(engine) == last, "all the way back and forth leads to the same document");
}

void check_scene(Engine& engine) {
  auto const scene = engine.scene();
  auto const map = scene.canvas_to_screen;
  for (auto const place : {Vec2{0, 0}, Vec2{1000, 1000}}) {
    auto const at = map(place);
    CHECK(std::isfinite(at.x) && std::isfinite(at.y), "the paper lies somewhere");
  }
  CHECK(scene.size.width_px > 0 && scene.size.height_px > 0, "the window has a size");
}

}  // namespace
}  // namespace inkflate

// Any stream of events leaves a document that can be written, and a history that leads back and forth.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  using namespace inkflate;
  Bytes bytes(data, size);
  EventSource source(bytes);
  Engine engine;
  if (bytes.below(2) == 0) begin_bending(engine);
  for (int i = 0; i < kMostEvents && !bytes.is_empty(); ++i) {
    engine.handle(source.next());
    if (bytes.below(4) == 0 && engine.has_work()) engine.work();
    if (bytes.below(16) == 0) check_scene(engine);
  }
  check_document(engine.document());
  check_history(engine);
  check_scene(engine);
  return 0;
}
