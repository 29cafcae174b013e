// SPDX-License-Identifier: Apache-2.0
#include "editor/tool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/rng.h"
#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/sketches.h"
#include "support/tool_hand.h"

namespace inkflate {
namespace {

constexpr Tool kTools[] = {Tool::Brush,  Tool::HelpLine, Tool::Eraser, Tool::Mark,
                           Tool::Deform, Tool::Select,   Tool::Hand};

Document some_document() {
  auto document = with_ring(with_disc(empty_document(), {300, 300}, 100), {600, 600}, 150, 80);
  document = with_open(document, {line_stroke({{100, 500}, {900, 520}})});
  return with_loose(document, circle_stroke({700, 200}, 60));
}

ToolPointer pointer_at(Vec2 place) { return {place, place, 1, 0, false, {}}; }

TEST(ToolStep, CancelEndsEveryGestureWithNothing) {
  for (auto const tool : kTools) {
    ToolHand hand(tool, some_document());
    hand.press({300, 300});
    hand.move({350, 320});
    hand.move({400, 380});
    auto const step = hand.cancel();
    EXPECT_TRUE(std::holds_alternative<ToolIdle>(step.state));
    EXPECT_EQ(step.effect, GestureEffect::Replace);
    EXPECT_TRUE(step.commands.empty());
    EXPECT_TRUE(step.is_end);
    EXPECT_EQ(hand.entries(), 0);
  }
}

TEST(ToolStep, EveryReleaseEndsItsGesture) {
  for (auto const tool : kTools) {
    ToolHand hand(tool, some_document());
    auto const step = hand.drag({300, 300}, {500, 500});
    EXPECT_TRUE(std::holds_alternative<ToolIdle>(step.state));
    EXPECT_TRUE(step.is_end);
  }
}

TEST(ToolStep, EventsThatDoNotFitChangeNothing) {
  auto const document = some_document();
  View const view;
  auto const pointer = pointer_at({300, 300});
  for (auto const tool : kTools) {
    for (ToolEvent const& event : {ToolEvent{ToolMove{pointer}}, ToolEvent{ToolRelease{pointer}}}) {
      auto const step = tool_step(tool, ToolIdle{}, event, {document, view});
      EXPECT_TRUE(std::holds_alternative<ToolIdle>(step.state));
      EXPECT_EQ(step.effect, GestureEffect::None);
      EXPECT_FALSE(step.is_end);
    }
    auto const pressed = tool_step(tool, ToolIdle{}, ToolPress{pointer}, {document, view});
    for (ToolEvent const& event : {ToolEvent{ToolPress{pointer}}, ToolEvent{ToolHover{pointer}}}) {
      auto const step = tool_step(tool, pressed.state, event, {document, view});
      EXPECT_EQ(step.state.index(), pressed.state.index());
      EXPECT_EQ(step.effect, GestureEffect::None);
    }
  }
}

TEST(ToolStep, AStateOfAnotherToolBecomesIdle) {
  auto const document = some_document();
  View const view;
  auto const pointer = pointer_at({300, 300});
  for (auto const tool : kTools) {
    ToolState const strange =
        tool == Tool::Hand ? ToolState{ToolErasing{}} : ToolState{ToolPanning{}};
    auto const step = tool_step(tool, strange, ToolMove{pointer}, {document, view});
    EXPECT_TRUE(std::holds_alternative<ToolIdle>(step.state));
    EXPECT_TRUE(step.commands.empty());
  }
}

TEST(ToolStep, WhatIsNotFiniteIsNotSeenAndAReleaseSoCancels) {
  auto const document = some_document();
  View const view;
  double const nan = std::numeric_limits<double>::quiet_NaN();
  auto const nowhere = pointer_at({nan, 5});
  for (auto const tool : kTools) {
    auto step = tool_step(tool, ToolIdle{}, ToolPress{nowhere}, {document, view});
    EXPECT_TRUE(std::holds_alternative<ToolIdle>(step.state));
    step = tool_step(tool, ToolIdle{}, ToolPress{pointer_at({300, 300})}, {document, view});
    auto const index = step.state.index();
    step = tool_step(tool, step.state, ToolMove{nowhere}, {document, view});
    EXPECT_EQ(step.state.index(), index);
    step = tool_step(tool, step.state, ToolRelease{nowhere}, {document, view});
    EXPECT_TRUE(step.is_end);
    EXPECT_EQ(step.effect, GestureEffect::Replace);
    EXPECT_TRUE(step.commands.empty());
  }
}

TEST(ToolStep, FarAwayIsTheEndOfThePlane) {
  auto const document = empty_document();
  View const view;
  auto pointer = pointer_at({1e300, -1e300});
  pointer.pressure = std::numeric_limits<double>::quiet_NaN();
  pointer.time_s = std::numeric_limits<double>::infinity();
  auto step = tool_step(Tool::Brush, ToolIdle{}, ToolPress{pointer}, {document, view});
  pointer.pressure = 1e9;
  step = tool_step(Tool::Brush, step.state, ToolRelease{pointer}, {document, view});
  ASSERT_EQ(step.commands.size(), 1u);
  EXPECT_TRUE(inkflate::apply(document, step.commands));
}

TEST(ToolStep, SettingsThatAreNoneStillDraw) {
  ToolHand hand(Tool::Brush, empty_document());
  double const nan = std::numeric_limits<double>::quiet_NaN();
  hand.view.settings = {nan, {}, nan, nan};
  hand.drag({100, 100}, {300, 100});
  EXPECT_EQ(hand.entries(), 1);
  EXPECT_FALSE(hand.was_refused());
  ToolHand eraser(Tool::Eraser, hand.document());
  eraser.view.settings = hand.view.settings;
  eraser.drag({200, 0}, {200, 200});
  EXPECT_FALSE(eraser.was_refused());
}

/// A hand that does anything: what it does is never refused, and the numbers of the document stay finite.
TEST(ToolStep, AnyWayOfAHandIsAccepted) {
  Rng rng(11);
  for (int run = 0; run < 60; ++run) {
    ToolHand hand(kTools[static_cast<std::size_t>(run) % std::size(kTools)], some_document());
    hand.view.camera = {{500, 500}, 0.3 + 2 * rng.uniform(), run % 2 == 0};
    hand.view.selection = {LayerId{1}, LayerId{2}, LayerId{40}};
    for (int i = 0; i < 40; ++i) {
      Vec2 const place = {1000 * rng.uniform(), 1000 * rng.uniform()};
      hand.modifiers = {rng.uniform() < 0.3, false, rng.uniform() < 0.3};
      hand.is_secondary = rng.uniform() < 0.2;
      double const choice = rng.uniform();
      if (choice < 0.25) hand.press(place, 1 + i % 3);
      if (choice >= 0.25 && choice < 0.75) hand.move(place);
      if (choice >= 0.75 && choice < 0.95) hand.release(place);
      if (choice >= 0.95) hand.cancel();
    }
    hand.cancel();
    EXPECT_FALSE(hand.was_refused()) << run;
  }
}

}  // namespace
}  // namespace inkflate
