// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "document/apply.h"
#include "editor/tools.h"
#include "support/editor_documents.h"
#include "support/sketches.h"
#include "support/tool_hand.h"

namespace inkflate {
namespace {

Stroke const& last_loose(ToolHand const& hand) {
  auto const& loose = hand.document().loose;
  return loose[loose.size() - 1]->stroke;
}

TEST(BrushTool, ADragIsOneLooseStrokeFromPressToRelease) {
  ToolHand hand(Tool::Brush, empty_document());
  auto const step = hand.drag({100, 100}, {300, 100});
  EXPECT_TRUE(step.is_end);
  EXPECT_EQ(hand.entries(), 1);
  ASSERT_EQ(hand.document().loose.size(), 1);
  auto const& stroke = last_loose(hand);
  EXPECT_EQ(stroke.samples.front().position, (Vec2{100, 100}));
  EXPECT_EQ(stroke.samples.back().position, (Vec2{300, 100}));
  EXPECT_EQ(stroke.kind, StrokeKind::Ink);
  EXPECT_EQ(stroke.depth, StrokeDepth::Near);
  EXPECT_TRUE(std::holds_alternative<ToolIdle>(hand.state()));
}

TEST(BrushTool, DrawsWithWidthAndColourOfTheSettings) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.view.settings.brush_px = 7;
  hand.view.settings.ink = {1, 2, 3};
  hand.drag({0, 0}, {50, 50});
  EXPECT_EQ(last_loose(hand).width_px, 7);
  EXPECT_EQ(last_loose(hand).colour, (Colour{1, 2, 3}));
}

TEST(BrushTool, HelpLinesAreOfTheirOwnKind) {
  ToolHand hand(Tool::HelpLine, empty_document());
  hand.drag({0, 0}, {50, 50});
  EXPECT_EQ(last_loose(hand).kind, StrokeKind::HelpLine);
}

TEST(BrushTool, TheSecondaryButtonDrawsBehind) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.is_secondary = true;
  hand.drag({0, 0}, {50, 50});
  EXPECT_EQ(last_loose(hand).depth, StrokeDepth::Far);
}

TEST(BrushTool, AClickIsADot) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.press({100, 100});
  hand.move({100.1, 100});
  hand.release({100, 100.1});
  ASSERT_EQ(hand.document().loose.size(), 1);
  ASSERT_EQ(last_loose(hand).samples.size(), 1u);
  EXPECT_EQ(last_loose(hand).samples[0].position, (Vec2{100, 100}));
}

TEST(BrushTool, SamplesOfARestingHandAreOneWithTheLargestPressure) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.pressure = 0.3;
  hand.press({100, 100});
  hand.pressure = 0.8;
  hand.move({100.2, 100});
  hand.pressure = 0.4;
  hand.move({100.2, 100.1});
  hand.move({120, 100});
  hand.release({140, 100});
  auto const& samples = last_loose(hand).samples;
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_EQ(samples[0].pressure, 0.8);
  EXPECT_EQ(samples[1].pressure, 0.4);
}

TEST(BrushTool, SlowMotionIsNotLost) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.press({100, 100});
  for (int i = 1; i <= 1000; ++i) hand.move({100 + 0.01 * i, 100});
  EXPECT_GT(std::get<ToolDrawing>(hand.state()).raw.samples.size(), 20u);
  hand.release({110.05, 100});
  EXPECT_NEAR(distance(last_loose(hand).samples.back().position, {110.05, 100}), 0, 1e-9);
}

TEST(BrushTool, HowNearSamplesMayBeIsMeasuredOnTheScreen) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.view.camera.zoom = 10;
  hand.press({500, 500});
  hand.move({501, 500});  // 0.1 px of the canvas
  hand.release({502, 500});
  EXPECT_EQ(last_loose(hand).samples.size(), 3u);
}

TEST(BrushTool, TimesCountFromThePressAndNeverRunBack) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.drag({0, 0}, {80, 0});
  auto const& samples = last_loose(hand).samples;
  EXPECT_EQ(samples[0].time_s, 0);
  EXPECT_NEAR(samples.back().time_s, 0.08, 1e-9);

  View const view;
  auto const document = empty_document();
  ToolPointer pointer = {{0, 0}, {0, 0}, 1, 50, false, {}};
  auto step = tool_step(Tool::Brush, ToolIdle{}, ToolPress{pointer}, {document, view});
  for (double const time_s : {51.0, 20.0, -1e300, 1e300, 51.5}) {
    pointer.canvas.x += 10;
    pointer.time_s = time_s;
    step = tool_step(Tool::Brush, step.state, ToolMove{pointer}, {document, view});
  }
  auto const& raw = std::get<ToolDrawing>(step.state).raw.samples;
  for (std::size_t i = 1; i < raw.size(); ++i) {
    EXPECT_LE(raw[i - 1].time_s, raw[i].time_s);
    EXPECT_LE(raw[i].time_s, 86'400);
  }
}

TEST(BrushTool, WhileItDrawsTheDocumentStays) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.press({0, 0});
  auto const step = hand.move({50, 0});
  EXPECT_EQ(step.effect, GestureEffect::None);
  EXPECT_TRUE(hand.document().loose.is_empty());
}

TEST(BrushTool, ShiftDrawsStraightFromThePress) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.press({100, 100});
  hand.move({150, 300});
  hand.modifiers.is_shift = true;
  hand.move({200, 250});
  EXPECT_EQ(std::get<ToolDrawing>(hand.state()).smooth.samples.size(), 2u);
  hand.release({300, 100});
  auto const& samples = last_loose(hand).samples;
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].position, (Vec2{100, 100}));
  EXPECT_EQ(samples[1].position, (Vec2{300, 100}));
}

TEST(BrushTool, ShiftLetGoBringsTheDrawnLineBack) {
  ToolHand straight_for_a_while(Tool::Brush, empty_document());
  ToolHand never(Tool::Brush, empty_document());
  for (auto* hand : {&straight_for_a_while, &never}) {
    hand->press({100, 100});
    for (int i = 1; i < 20; ++i) {
      hand->modifiers.is_shift = hand == &straight_for_a_while && i > 5 && i < 15;
      hand->move({100.0 + 10 * i, 100.0 + (i % 3)});
    }
    hand->release({300, 100});
  }
  EXPECT_EQ(last_loose(straight_for_a_while), last_loose(never));
}

TEST(BrushTool, SmoothingOffLeavesTheLineAsDrawn) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.view.settings.smoothing = 0;
  hand.press({0, 0});
  std::vector<Vec2> const places = {{10, 3}, {20, -3}, {30, 3}, {40, 0}};
  for (auto const place : places) hand.move(place);
  hand.release(places.back());
  auto const& samples = last_loose(hand).samples;
  ASSERT_EQ(samples.size(), 5u);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(samples[i + 1].position, places[i]);
}

TEST(BrushTool, CancelLeavesNothing) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.press({0, 0});
  hand.move({50, 0});
  EXPECT_TRUE(hand.cancel().is_end);
  EXPECT_TRUE(hand.document().loose.is_empty());
  EXPECT_EQ(hand.entries(), 0);
  hand.drag({0, 0}, {10, 10});
  EXPECT_EQ(hand.entries(), 1);
}

TEST(BrushTool, AMirroredViewDrawsWhereThePointerIs) {
  ToolHand hand(Tool::Brush, empty_document());
  hand.view.camera.is_mirrored = true;
  hand.drag({100, 100}, {300, 100});
  EXPECT_EQ(last_loose(hand).samples.front().position, (Vec2{900, 100}));
  EXPECT_EQ(last_loose(hand).samples.back().position, (Vec2{700, 100}));
}

TEST(BrushTool, AStrokeEndsWhereADocumentHoldsNoLongerOne) {
  auto const document = empty_document();
  View view;
  view.settings.smoothing = 0;
  ToolDrawing drawing;
  drawing.raw.samples.resize(DocumentLimits::kSamplesOfStroke - 1);
  drawing.smooth = drawing.raw;
  ToolPointer const pointer = {{5, 5}, {5, 5}, 1, 0, false, {}};
  auto const step = tool_step(Tool::Brush, std::move(drawing), ToolMove{pointer}, {document, view});
  EXPECT_TRUE(step.is_end);
  ASSERT_EQ(step.commands.size(), 1u);
  EXPECT_TRUE(inkflate::apply(document, step.commands));
}

constexpr auto kOpen = [](Layer& layer) { layer.is_open = true; };

TEST(LayerToDrawOn, IsNoneWithoutAnOpenLayer) {
  View view;
  view.selection = {LayerId{1}};
  EXPECT_EQ(layer_to_draw_on(with_disc(empty_document(), {9, 9}, 5), view), LayerId::None);
}

TEST(LayerToDrawOn, IsTheTopmostOpenOneOrTheOneThatIsSelected) {
  auto document = empty_document();
  for (int i = 0; i < 3; ++i) document = with_open(document, {});
  document = with_disc(document, {9, 9}, 5);
  View view;
  EXPECT_EQ(layer_to_draw_on(document, view), LayerId{3});
  view.selection = {LayerId{1}, LayerId{4}};  // only one of them is open
  EXPECT_EQ(layer_to_draw_on(document, view), LayerId{1});
  view.selection = {LayerId{1}, LayerId{2}};
  EXPECT_EQ(layer_to_draw_on(document, view), LayerId{3});
}

TEST(LayerToDrawOn, PassesOverHiddenAndLockedOnes) {
  auto document = with_open(with_open(with_open(empty_document(), {}), {}), {});
  document = with_changed(document, LayerId{3}, [](Layer& layer) { layer.is_hidden = true; });
  document = with_changed(document, LayerId{2}, [](Layer& layer) { layer.is_locked = true; });
  EXPECT_EQ(layer_to_draw_on(document, View{}), LayerId{1});
}

TEST(BrushTool, DrawsOnTheOpenLayer) {
  auto const document =
      with_changed(with_disc(empty_document(), {500, 500}, 50), LayerId{1}, kOpen);
  ToolHand hand(Tool::Brush, document);
  hand.drag({100, 100}, {300, 100});
  EXPECT_TRUE(hand.document().loose.is_empty());
  EXPECT_EQ(hand.document().layers->front()->strokes.size(), 2);
}

}  // namespace
}  // namespace inkflate
