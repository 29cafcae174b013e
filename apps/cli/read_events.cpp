// SPDX-License-Identifier: Apache-2.0
#include "cli/read_events.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cli/event_line.h"
#include "io/parse_json.h"

namespace inkflate::cli {
namespace {

constexpr double kSamplePauseS =
    0.01;  // between the points of a stroke: a pen that reports 100 times a second
constexpr double kStrokePauseS = 1;   // before a stroke or click: too long for a double click
constexpr double kClickPauseS = 0.1;  // between the clicks of a double click

Modifiers take_modifiers(EventLine& line) {
  return {line.flag("shift"), line.flag("ctrl"), line.flag("alt")};
}

PointerKind take_kind(EventLine& line, PointerKind fallback) {
  return line.choice<PointerKind>(
      "kind", fallback,
      {{"mouse", PointerKind::Mouse}, {"pen", PointerKind::Pen}, {"touch", PointerKind::Touch}});
}

PointerButton take_button(EventLine& line, PointerButton fallback) {
  return line.choice<PointerButton>("button", fallback,
                                    {{"none", PointerButton::None},
                                     {"primary", PointerButton::Primary},
                                     {"middle", PointerButton::Middle},
                                     {"secondary", PointerButton::Secondary},
                                     {"eraser", PointerButton::Eraser}});
}

/// Turns lines into steps, and keeps the time where a line gives none.
class EventReader {
 public:
  std::vector<RecordedEvent>& steps() { return steps_; }

  /// What is wrong with the line, if anything.
  std::optional<std::string> read(nlohmann::json const& object, int number) {
    if (!object.is_object()) return "no JSON object";
    number_ = number;
    EventLine line(object);
    if (line.has("comment")) line.text("comment");
    auto const kind = std::find_if(kKinds.begin(), kKinds.end(),
                                   [&](auto const& each) { return line.has(each.first); });
    if (kind != kKinds.end()) (this->*kind->second)(line);
    return line.fault();
  }

 private:
  using Read = void (EventReader::*)(EventLine& line);
  static std::array<std::pair<char const*, Read>, 12> const kKinds;

  void add(RecordedStep step) { steps_.push_back({std::move(step), number_}); }

  double take_time(EventLine& line, char const* name, double pause_s) {
    double const time_s = line.number(name, time_s_ + pause_s);
    if (std::isfinite(time_s)) time_s_ = time_s;
    return time_s;
  }

  void read_pointer(EventLine& line) {
    PointerEvent event;
    event.action = line.choice<PointerAction>("pointer", PointerAction::Move,
                                              {{"press", PointerAction::Press},
                                               {"move", PointerAction::Move},
                                               {"release", PointerAction::Release},
                                               {"cancel", PointerAction::Cancel}});
    bool const has_button =
        event.action == PointerAction::Press || event.action == PointerAction::Release;
    event.kind = take_kind(line, PointerKind::Mouse);
    event.id = line.whole_number("id", 0);
    event.button = take_button(line, has_button ? PointerButton::Primary : PointerButton::None);
    event.screen = line.point("at");
    event.pressure = line.number("pressure", 0.5);
    event.time_s = take_time(line, "time", kSamplePauseS);
    event.modifiers = take_modifiers(line);
    add(event);
  }

  /// What presses, moves and releases have in common.
  PointerEvent take_gesture(EventLine& line, PointerKind fallback) {
    PointerEvent event;
    event.kind = take_kind(line, fallback);
    event.id = line.whole_number("id", 0);
    event.button = take_button(line, PointerButton::Primary);
    event.modifiers = take_modifiers(line);
    event.time_s = take_time(line, "start", kStrokePauseS);
    return event;
  }

  void add_pointer(PointerEvent event, PointerAction action, double time_s) {
    event.action = action;
    event.time_s = time_s;
    if (std::isfinite(time_s)) time_s_ = time_s;
    if (action == PointerAction::Move) event.button = PointerButton::None;
    add(event);
  }

  void read_stroke(EventLine& line) {
    auto const points = line.points("stroke");
    auto event = take_gesture(line, PointerKind::Pen);
    double const step_s = line.number("step", kSamplePauseS);
    double const start_s = event.time_s;
    for (std::size_t i = 0; i < points.size(); ++i) {
      event.screen = points[i].position;
      event.pressure = points[i].pressure;
      add_pointer(event, i == 0 ? PointerAction::Press : PointerAction::Move,
                  start_s + static_cast<double>(i) * step_s);
    }
    add_pointer(event, PointerAction::Release,
                start_s + static_cast<double>(points.size()) * step_s);
  }

  void read_click(EventLine& line) {
    auto const place = line.point("click");
    auto event = take_gesture(line, PointerKind::Mouse);
    event.screen = place;
    int const count = line.whole_number("count", 1);
    if (count < 1 || count > 3) return line.fail("count is not 1, 2 or 3");
    double time_s = event.time_s;
    for (int i = 0; i < count; ++i, time_s += kClickPauseS) {
      add_pointer(event, PointerAction::Press, time_s);
      add_pointer(event, PointerAction::Release, time_s + kSamplePauseS);
    }
  }

  void read_key(EventLine& line) {
    enum class Phase { Both, Press, Repeat, Release };
    KeyEvent event;
    event.key = line.text("key");
    auto const phase = line.choice<Phase>(
        "phase", Phase::Both,
        {{"press", Phase::Press}, {"repeat", Phase::Repeat}, {"release", Phase::Release}});
    event.is_repeat = phase == Phase::Repeat;
    event.modifiers = take_modifiers(line);
    event.time_s = take_time(line, "time", kSamplePauseS);
    if (phase != Phase::Release) add(event);
    event.is_repeat = false;
    event.is_press = false;
    if (phase == Phase::Both || phase == Phase::Release) add(event);
  }

  void read_wheel(EventLine& line) {
    WheelEvent event;
    event.delta_px = line.point("wheel");
    event.screen = line.point("at");
    event.modifiers = take_modifiers(line);
    add(event);
  }

  void read_pinch(EventLine& line) {
    GestureEvent event;
    event.scale = line.number("pinch", 1);
    event.screen = line.point("at");
    if (line.has("moved")) event.moved_px = line.point("moved");
    add(event);
  }

  void read_action(EventLine& line) {
    auto name = line.text("action");
    add(ActionEvent{std::move(name), line.text("argument", "")});
  }

  void read_resize(EventLine& line) {
    auto const size = line.point("resize");
    add(ResizeEvent{size.x, size.y});
  }

  void read_open(EventLine& line) {
    OpenStep step;
    step.name = line.file_name("open");
    step.use = line.choice<FileUse>(
        "use", FileUse::Open,
        {{"open", FileUse::Open}, {"add", FileUse::Add}, {"template", FileUse::Template}});
    add(std::move(step));
  }

  void read_save(EventLine& line) { add(SaveStep{line.file_name("save")}); }

  void read_picture(EventLine& line) { add(PictureStep{line.file_name("picture")}); }

  void read_hash(EventLine& line) {
    if (line.is_null("hash")) return add(HashStep{});
    auto hash = line.text("hash");
    bool const is_hash =
        hash.size() == 16 && hash.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_hash) line.fail("a hash has 16 hexadecimal digits");
    add(HashStep{std::move(hash)});
  }

  std::vector<RecordedEvent> steps_;
  double time_s_ = 0;
  int number_ = 0;
};

std::array<std::pair<char const*, EventReader::Read>, 12> const EventReader::kKinds = {
    {{"pointer", &EventReader::read_pointer},
     {"stroke", &EventReader::read_stroke},
     {"click", &EventReader::read_click},
     {"key", &EventReader::read_key},
     {"wheel", &EventReader::read_wheel},
     {"pinch", &EventReader::read_pinch},
     {"action", &EventReader::read_action},
     {"resize", &EventReader::read_resize},
     {"open", &EventReader::read_open},
     {"save", &EventReader::read_save},
     {"picture", &EventReader::read_picture},
     {"hash", &EventReader::read_hash}}};

Error at_line(ErrorCode code, std::string const& what, int number) {
  return {code, "line " + std::to_string(number) + ": " + what, number};
}

}  // namespace

Result<std::vector<RecordedEvent>> read_events(std::string_view text) {
  EventReader reader;
  for (int number = 1; !text.empty(); ++number) {
    auto const line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    auto const object = parse_json(line);
    if (!object) return at_line(object.error().code, object.error().message, number);
    if (auto const fault = reader.read(*object, number)) {
      return at_line(ErrorCode::BadInput, *fault, number);
    }
    if (std::ssize(reader.steps()) > kMaxRecordedEvents) {
      return at_line(ErrorCode::TooLarge, "more than 1 000 000 steps", number);
    }
  }
  return std::move(reader.steps());
}

}  // namespace inkflate::cli
