// SPDX-License-Identifier: Apache-2.0
#include "cli/read_events.h"

#include <gtest/gtest.h>

#include <cmath>

namespace inkflate::cli {
namespace {

std::vector<RecordedEvent> read(std::string_view text) {
  auto events = read_events(text);
  EXPECT_TRUE(events) << (events ? "" : events.error().message);
  return events ? *events : std::vector<RecordedEvent>();
}

template <typename T>
T const& step(std::vector<RecordedEvent> const& events, std::size_t index) {
  return std::get<T>(events.at(index).step);
}

template <typename T>
T const& event(std::vector<RecordedEvent> const& events, std::size_t index) {
  return std::get<T>(step<Event>(events, index));
}

Error refused(std::string_view text) {
  auto const events = read_events(text);
  EXPECT_FALSE(events) << text;
  return events ? Error{} : events.error();
}

TEST(ReadEvents, APointerSaysAllThatAPointerCan) {
  auto const events = read(
      R"({"pointer": "press", "at": [1.5, -2], "kind": "touch", "id": 7, "button": "secondary",)"
      R"( "pressure": 0.25, "time": 3, "shift": true, "ctrl": true, "alt": true})");
  auto const& pointer = event<PointerEvent>(events, 0);
  EXPECT_EQ(pointer.action, PointerAction::Press);
  EXPECT_EQ(pointer.screen, (Vec2{1.5, -2}));
  EXPECT_EQ(pointer.kind, PointerKind::Touch);
  EXPECT_EQ(pointer.id, 7);
  EXPECT_EQ(pointer.button, PointerButton::Secondary);
  EXPECT_EQ(pointer.pressure, 0.25);
  EXPECT_EQ(pointer.time_s, 3);
  EXPECT_EQ(pointer.modifiers, (Modifiers{true, true, true}));
}

TEST(ReadEvents, WhatAPointerLeavesOutIsUsual) {
  auto const events = read(R"({"pointer": "press", "at": [0, 0]}
{"pointer": "move", "at": [1, 0]}
{"pointer": "release", "at": [2, 0], "time": 5}
{"pointer": "cancel", "at": [2, 0]})");
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(event<PointerEvent>(events, 0).button, PointerButton::Primary);
  EXPECT_EQ(event<PointerEvent>(events, 0).kind, PointerKind::Mouse);
  EXPECT_EQ(event<PointerEvent>(events, 1).button, PointerButton::None);
  EXPECT_EQ(event<PointerEvent>(events, 2).button, PointerButton::Primary);
  EXPECT_GT(event<PointerEvent>(events, 1).time_s, event<PointerEvent>(events, 0).time_s);
  EXPECT_GT(event<PointerEvent>(events, 3).time_s, 5);
  EXPECT_EQ(events[3].line, 4);
}

TEST(ReadEvents, AStrokeIsAPressMovesAndARelease) {
  auto const events = read(
      R"({"stroke": [[1, 2], [3, 4, 0.75]], "button": "eraser", "start": 10, "step": 0.5, "alt": true})");
  ASSERT_EQ(events.size(), 3U);
  auto const& press = event<PointerEvent>(events, 0);
  auto const& move = event<PointerEvent>(events, 1);
  auto const& release = event<PointerEvent>(events, 2);
  EXPECT_EQ(press.action, PointerAction::Press);
  EXPECT_EQ(press.button, PointerButton::Eraser);
  EXPECT_EQ(press.kind, PointerKind::Pen);
  EXPECT_EQ(press.pressure, 0.5);
  EXPECT_EQ(move.action, PointerAction::Move);
  EXPECT_EQ(move.button, PointerButton::None);
  EXPECT_EQ(move.screen, (Vec2{3, 4}));
  EXPECT_EQ(move.pressure, 0.75);
  EXPECT_EQ(move.time_s, 10.5);
  EXPECT_EQ(release.action, PointerAction::Release);
  EXPECT_EQ(release.button, PointerButton::Eraser);
  EXPECT_EQ(release.screen, (Vec2{3, 4}));
  EXPECT_EQ(release.time_s, 11);
  EXPECT_TRUE(release.modifiers.is_alt);
}

TEST(ReadEvents, TwoStrokesWithoutTimesAreNoDoubleClick) {
  auto const events = read("{\"stroke\": [[1, 2]]}\n{\"stroke\": [[1, 2]]}");
  EXPECT_GE(event<PointerEvent>(events, 2).time_s, event<PointerEvent>(events, 1).time_s + 0.9);
}

TEST(ReadEvents, ClicksComeCloseTogether) {
  auto const events = read(R"({"click": [5, 6], "count": 2, "button": "secondary"})");
  ASSERT_EQ(events.size(), 4U);
  EXPECT_EQ(event<PointerEvent>(events, 2).action, PointerAction::Press);
  EXPECT_EQ(event<PointerEvent>(events, 2).screen, (Vec2{5, 6}));
  EXPECT_NEAR(event<PointerEvent>(events, 2).time_s, event<PointerEvent>(events, 0).time_s + 0.1,
              1e-9);
}

TEST(ReadEvents, AKeyIsPressedAndReleasedUnlessItSaysOtherwise) {
  auto const events = read(R"({"key": "z", "ctrl": true}
{"key": " ", "phase": "press"}
{"key": " ", "phase": "repeat"}
{"key": " ", "phase": "release", "time": 9})");
  ASSERT_EQ(events.size(), 5U);
  EXPECT_TRUE(event<KeyEvent>(events, 0).is_press);
  EXPECT_FALSE(event<KeyEvent>(events, 1).is_press);
  EXPECT_TRUE(event<KeyEvent>(events, 1).modifiers.is_ctrl);
  EXPECT_EQ(event<KeyEvent>(events, 2).key, " ");
  EXPECT_TRUE(event<KeyEvent>(events, 2).is_press);
  EXPECT_FALSE(event<KeyEvent>(events, 2).is_repeat);
  EXPECT_TRUE(event<KeyEvent>(events, 3).is_repeat);
  EXPECT_FALSE(event<KeyEvent>(events, 4).is_press);
  EXPECT_EQ(event<KeyEvent>(events, 4).time_s, 9);
}

TEST(ReadEvents, EveryOtherEventHasALine) {
  auto const events = read(R"({"wheel": [1, -2], "at": [3, 4], "ctrl": true}
{"pinch": 1.5, "at": [3, 4], "moved": [5, 6]}
{"pinch": 0.5, "at": [3, 4]}
{"action": "simplify"}
{"action": "set_fill", "argument": "#ff0000"}
{"resize": [640, 480]})");
  ASSERT_EQ(events.size(), 6U);
  EXPECT_EQ(event<WheelEvent>(events, 0).delta_px, (Vec2{1, -2}));
  EXPECT_EQ(event<WheelEvent>(events, 0).screen, (Vec2{3, 4}));
  EXPECT_TRUE(event<WheelEvent>(events, 0).modifiers.is_ctrl);
  EXPECT_EQ(event<GestureEvent>(events, 1).scale, 1.5);
  EXPECT_EQ(event<GestureEvent>(events, 1).moved_px, (Vec2{5, 6}));
  EXPECT_EQ(event<GestureEvent>(events, 2).moved_px, (Vec2{}));
  EXPECT_EQ(event<ActionEvent>(events, 3).name, "simplify");
  EXPECT_EQ(event<ActionEvent>(events, 4).argument, "#ff0000");
  EXPECT_EQ(event<ResizeEvent>(events, 5).width_px, 640);
  EXPECT_EQ(event<ResizeEvent>(events, 5).height_px, 480);
}

TEST(ReadEvents, StepsThatAreNoEventsHaveOneToo) {
  auto const events = read(R"({"open": "a.svg"}
{"open": "b/c.png", "use": "template", "comment": "to trace"}
{"save": "x.inkflate"}
{"picture": "x.png"}
{"hash": null}
{"hash": "0123456789abcdef"})");
  ASSERT_EQ(events.size(), 6U);
  EXPECT_EQ(step<OpenStep>(events, 0).name, "a.svg");
  EXPECT_EQ(step<OpenStep>(events, 0).use, FileUse::Open);
  EXPECT_EQ(step<OpenStep>(events, 1).use, FileUse::Template);
  EXPECT_EQ(step<SaveStep>(events, 2).name, "x.inkflate");
  EXPECT_EQ(step<PictureStep>(events, 3).name, "x.png");
  EXPECT_EQ(step<HashStep>(events, 4).expected, "");
  EXPECT_EQ(step<HashStep>(events, 5).expected, "0123456789abcdef");
}

TEST(ReadEvents, CommentsAndEmptyLinesDoNothing) {
  EXPECT_TRUE(read("").empty());
  EXPECT_TRUE(read("\n  \n{\"comment\": \"the body\"}\r\n{}\n").empty());
}

TEST(ReadEvents, WhatIsNotFiniteCanBeRecorded) {
  auto const events = read(
      R"({"pointer": "move", "at": ["nan", "inf"], "pressure": "-inf", "time": "nan"}
{"pointer": "move", "at": [0, 0]})");
  auto const& pointer = event<PointerEvent>(events, 0);
  EXPECT_TRUE(std::isnan(pointer.screen.x));
  EXPECT_TRUE(std::isinf(pointer.screen.y));
  EXPECT_LT(pointer.pressure, 0);
  EXPECT_TRUE(std::isnan(pointer.time_s));
  EXPECT_TRUE(std::isfinite(event<PointerEvent>(events, 1).time_s));
}

TEST(ReadEvents, ErrorsNameTheLine) {
  auto const error = refused("{}\n\n{\"key\": 5}");
  EXPECT_EQ(error.code, ErrorCode::BadInput);
  EXPECT_EQ(error.index, 3);
  EXPECT_EQ(error.message, "line 3: key is missing or no text");
}

TEST(ReadEvents, WhatIsNoRecordingIsRefused) {
  for (char const* const line : {
           "[]",
           "7",
           "{",
           "{} {}",
           "\xff\xfe",
           R"({"pointer": "push", "at": [0, 0]})",
           R"({"pointer": "press"})",
           R"({"pointer": "press", "at": [0]})",
           R"({"pointer": "press", "at": [0, "zero"]})",
           R"({"pointer": "press", "at": [0, 1e999]})",
           R"({"pointer": "press", "at": [0, 0], "id": 0.5})",
           R"({"pointer": "press", "at": [0, 0], "id": 1e10})",
           R"({"pointer": "press", "at": [0, 0], "id": "nan"})",
           R"({"pointer": "press", "at": [0, 0], "kind": "foot"})",
           R"({"pointer": "press", "at": [0, 0], "button": 1})",
           R"({"pointer": "press", "at": [0, 0], "shift": 1})",
           R"({"pointer": "press", "at": [0, 0], "shfit": true})",
           R"({"pointer": "press", "at": [0, 0], "key": "a"})",
           R"({"stroke": []})",
           R"({"stroke": "long"})",
           R"({"stroke": [1, 2]})",
           R"({"stroke": [[1]]})",
           R"({"stroke": [[1, 2, 3, 4]]})",
           R"({"stroke": [[1, null]]})",
           R"({"click": [0, 0], "count": 4})",
           R"({"click": 0})",
           R"({"key": "a", "phase": "held"})",
           R"({"wheel": [0, 0]})",
           R"({"pinch": [], "at": [0, 0]})",
           R"({"action": null})",
           R"({"action": "undo", "argument": 3})",
           R"({"resize": 100})",
           R"({"open": "/etc/passwd"})",
           R"({"open": "../a.svg"})",
           R"({"open": "a/../../b.svg"})",
           R"({"open": ""})",
           R"({"open": "a\u0000b"})",
           R"({"open": "a.svg", "use": "eat"})",
           R"({"save": "../x.inkflate"})",
           R"({"picture": "/x.png"})",
           R"({"hash": "0123"})",
           R"({"hash": "0123456789ABCDEF"})",
           R"({"hash": 5})",
           R"({"comment": 5})",
           R"({"unheard": 1})",
       }) {
    auto const error = refused(line);
    EXPECT_EQ(error.code, ErrorCode::BadInput) << line;
    EXPECT_EQ(error.index, 1) << line;
  }
}

TEST(ReadEvents, LimitsAreKept) {
  EXPECT_EQ(refused(std::string(100, '[')).code, ErrorCode::TooLarge);
  std::string stroke = "{\"stroke\": [";
  for (int i = 0; i < kMaxRecordedEvents; ++i) stroke += "[0,0],";
  stroke += "[0,0]]}";
  EXPECT_EQ(refused(stroke).code, ErrorCode::TooLarge);
}

}  // namespace
}  // namespace inkflate::cli
