// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/editor_documents.h"
#include "support/sketches.h"
#include "support/tool_hand.h"

namespace inkflate {
namespace {

Document two_lines() {
  return with_loose(with_loose(empty_document(), line_stroke({{100, 200}, {900, 200}})),
                    line_stroke({{100, 400}, {900, 400}}));
}

Document const& document_of(ToolHand const& hand) { return hand.document(); }

bool is_open(ToolHand const& hand, int layer) {
  return (*hand.document().layers)[static_cast<std::size_t>(layer)]->layer.is_open;
}

TEST(EraserTool, CutsTheLineThatItCrosses) {
  ToolHand hand(Tool::Eraser, two_lines());
  hand.drag({500, 100}, {500, 300});
  EXPECT_EQ(document_of(hand).loose.size(), 3);
  EXPECT_EQ(hand.entries(), 1);
  EXPECT_FALSE(hand.was_refused());
}

TEST(EraserTool, ItsRadiusIsOneOfTheScreen) {
  ToolHand hand(Tool::Eraser, two_lines());
  hand.view.camera.zoom = 2;
  hand.view.settings.eraser_px = 20;
  hand.press({500, -100});  // canvas (500, 200)
  hand.release({500, -100});
  auto const& loose = document_of(hand).loose;
  ASSERT_EQ(loose.size(), 3);
  EXPECT_NEAR(loose[0]->stroke.samples.back().position.x, 490, 1e-6);
  EXPECT_NEAR(loose[1]->stroke.samples.front().position.x, 510, 1e-6);
}

TEST(EraserTool, NothingMetIsNoEntry) {
  ToolHand hand(Tool::Eraser, two_lines());
  hand.drag({100, 300}, {900, 300});
  EXPECT_EQ(hand.entries(), 0);
  EXPECT_FALSE(hand.was_refused());
}

TEST(EraserTool, GoingOverTheSamePlaceAgainDoesNothingMore) {
  ToolHand hand(Tool::Eraser, two_lines());
  hand.press({500, 200});
  for (int i = 0; i < 20; ++i) hand.move({500.0 + (i % 2), 200});
  hand.release({500, 200});
  EXPECT_FALSE(hand.was_refused());
  EXPECT_EQ(document_of(hand).loose.size(), 3);
}

TEST(EraserTool, AltTakesWholeLines) {
  ToolHand hand(Tool::Eraser, two_lines());
  hand.modifiers.is_alt = true;
  hand.press({500, 100});
  hand.move({500, 250});
  EXPECT_EQ(document_of(hand).loose.size(), 1);
  hand.move({500, 500});
  hand.release({500, 500});
  EXPECT_TRUE(document_of(hand).loose.is_empty());
  EXPECT_EQ(hand.entries(), 1);
  EXPECT_FALSE(hand.was_refused());
}

TEST(EraserTool, CancelBringsAllBack) {
  for (bool const is_alt : {false, true}) {
    ToolHand hand(Tool::Eraser, two_lines());
    hand.modifiers.is_alt = is_alt;
    hand.press({500, 200});
    hand.move({500, 400});
    hand.cancel();
    EXPECT_EQ(document_of(hand).loose.size(), 2);
    EXPECT_EQ(hand.entries(), 0);
  }
}

TEST(EraserTool, PressedOnTheLineOfAClosedLayerItOpensItAndErases) {
  ToolHand hand(Tool::Eraser, with_disc(empty_document(), {500, 500}, 200));
  hand.press({700, 500});
  EXPECT_TRUE(is_open(hand, 0));
  hand.move({700, 540});
  hand.release({700, 540});
  // A closed circle, opened where it starts: one piece that is shorter.
  auto const& strokes = document_of(hand).layers->front()->strokes;
  ASSERT_GE(strokes.size(), 1);
  EXPECT_GT(distance(strokes[0]->stroke.samples.front().position, {700, 500}), 11);
  EXPECT_EQ(hand.entries(), 1);
  EXPECT_FALSE(hand.was_refused());
}

TEST(EraserTool, AltOnTheLineOfAClosedLayerTakesThatLineAway) {
  ToolHand hand(Tool::Eraser, with_ring(empty_document(), {500, 500}, 200, 100));
  hand.modifiers.is_alt = true;
  hand.click({600, 500});
  EXPECT_TRUE(is_open(hand, 0));
  EXPECT_EQ(document_of(hand).layers->front()->strokes.size(), 1);
  EXPECT_FALSE(hand.was_refused());
}

TEST(EraserTool, TheNearestLayerIsOpened) {
  auto const document = with_disc(with_disc(empty_document(), {500, 500}, 200), {500, 500}, 201);
  ToolHand hand(Tool::Eraser, document);
  hand.click({700, 500});
  EXPECT_FALSE(is_open(hand, 0));
  EXPECT_TRUE(is_open(hand, 1));
}

TEST(EraserTool, RoughStrokesComeBeforeClosedLayers) {
  auto const document = with_loose(with_disc(empty_document(), {500, 500}, 200),
                                   line_stroke({{600, 500}, {800, 500}}));
  ToolHand hand(Tool::Eraser, document);
  hand.click({700, 500});
  EXPECT_FALSE(is_open(hand, 0));
  EXPECT_EQ(document_of(hand).loose.size(), 2);
}

TEST(EraserTool, LockedAndHiddenLayersStayClosed) {
  auto const document = with_disc(empty_document(), {500, 500}, 200);
  auto const locked =
      with_changed(document, LayerId{1}, [](Layer& layer) { layer.is_locked = true; });
  auto const hidden =
      with_changed(document, LayerId{1}, [](Layer& layer) { layer.is_hidden = true; });
  for (auto const& safe : {locked, hidden}) {
    ToolHand hand(Tool::Eraser, safe);
    hand.click({700, 500});
    EXPECT_FALSE(is_open(hand, 0));
    EXPECT_EQ(hand.entries(), 0);
  }
}

TEST(EraserTool, InsideOfALayerItOpensNothing) {
  ToolHand hand(Tool::Eraser, with_disc(empty_document(), {500, 500}, 200));
  hand.drag({500, 500}, {600, 500});
  EXPECT_EQ(hand.entries(), 0);
}

TEST(EraserTool, OnItsWayItOpensTheFirstLayerThatItMeetsAndNoOther) {
  auto const two = with_disc(with_disc(empty_document(), {500, 500}, 200), {900, 500}, 100);
  ToolHand hand(Tool::Eraser, two);
  hand.drag({600, 500}, {1200, 500});
  EXPECT_EQ(hand.entries(), 1);
  EXPECT_TRUE(is_open(hand, 0));
  EXPECT_FALSE(is_open(hand, 1));
}

TEST(EraserTool, ALayerWithoutStrokesIsNotOpened) {
  Layer layer;
  layer.outlines = {circle_outline({500, 500}, 200)};
  ToolHand hand(Tool::Eraser, with_layer(empty_document(), layer, {}));
  hand.click({700, 500});
  EXPECT_EQ(hand.entries(), 0);
}

TEST(EraserTool, ALayerIsOpenedByItsStrokesToo) {
  Layer layer;
  layer.outlines = {circle_outline({500, 500}, 200)};
  auto const document =
      with_layer(empty_document(), layer, {line_stroke({{450, 500}, {550, 500}})});
  ToolHand hand(Tool::Eraser, document);
  hand.click({500, 500});
  EXPECT_TRUE(is_open(hand, 0));
  EXPECT_EQ(document_of(hand).layers->front()->strokes.size(), 2);
}

TEST(EraserTool, HoverNamesTheLayerUnderIt) {
  ToolHand hand(Tool::Eraser, with_disc(empty_document(), {500, 500}, 200));
  hand.hover({500, 500});
  EXPECT_EQ(hand.view.hover, LayerId{1});
  EXPECT_FALSE(hand.hover({510, 500}).hover);  // no news
  hand.hover({900, 900});
  EXPECT_EQ(hand.view.hover, LayerId::None);
}

}  // namespace
}  // namespace inkflate
