// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "editor/pick.h"
#include "support/editor_documents.h"
#include "support/sketches.h"
#include "support/tool_hand.h"

namespace inkflate {
namespace {

constexpr LayerId kBack{1};
constexpr LayerId kFront{2};
constexpr LayerId kAside{3};

using Ids = std::vector<LayerId>;

/// One disc behind another, and one aside.
Document three_discs() {
  auto const two = with_disc(with_disc(empty_document(), {300, 300}, 100), {300, 300}, 90);
  return with_disc(two, {700, 700}, 50);
}

Vec2 centre_of(ToolHand const& hand, LayerId layer) {
  return layer_box(*find_layer(hand.document(), layer)).centre();
}

void expect_place(ToolHand const& hand, LayerId layer, Vec2 place) {
  EXPECT_NEAR(distance(centre_of(hand, layer), place), 0, 1e-9);
}

TEST(SelectTool, AClickSelectsTheNearestAndTheSecondaryButtonTheFarthest) {
  ToolHand hand(Tool::Select, three_discs());
  hand.click({300, 300});
  EXPECT_EQ(hand.view.selection, Ids{kFront});
  hand.is_secondary = true;
  hand.click({300, 300});
  EXPECT_EQ(hand.view.selection, Ids{kBack});
  EXPECT_EQ(hand.entries(), 0);
}

TEST(SelectTool, ShiftAddsAndTakesAway) {
  ToolHand hand(Tool::Select, three_discs());
  hand.click({700, 700});
  hand.modifiers.is_shift = true;
  hand.click({300, 300});
  EXPECT_EQ(hand.view.selection, (Ids{kFront, kAside}));
  hand.click({700, 700});
  EXPECT_EQ(hand.view.selection, Ids{kFront});
  hand.click({900, 100});
  EXPECT_EQ(hand.view.selection, Ids{kFront});
}

TEST(SelectTool, AClickOnNothingClears) {
  ToolHand hand(Tool::Select, three_discs());
  hand.click({700, 700});
  hand.click({900, 100});
  EXPECT_TRUE(hand.view.selection.empty());
}

TEST(SelectTool, ATrembleOfAClickMovesNothing) {
  ToolHand hand(Tool::Select, three_discs());
  hand.press({700, 700});
  hand.move({702, 702});
  hand.release({701, 699});
  EXPECT_EQ(hand.entries(), 0);
  EXPECT_EQ(hand.view.selection, Ids{kAside});
}

TEST(SelectTool, ADragMovesTheLayerAndSelectsIt) {
  ToolHand hand(Tool::Select, three_discs());
  hand.drag({700, 700}, {760, 680});
  EXPECT_EQ(hand.view.selection, Ids{kAside});
  expect_place(hand, kAside, {760, 680});
  expect_place(hand, kFront, {300, 300});
  EXPECT_EQ(hand.entries(), 1);
}

TEST(SelectTool, ADragOnASelectedLayerMovesAllThatAreSelected) {
  ToolHand hand(Tool::Select, three_discs());
  hand.view.selection = {kFront, kAside};
  hand.drag({700, 700}, {710, 700});
  expect_place(hand, kAside, {710, 700});
  expect_place(hand, kFront, {310, 300});
  EXPECT_EQ(hand.view.selection, (Ids{kFront, kAside}));
}

TEST(SelectTool, ASelectedLayerBehindOthersIsTheOneThatIsDragged) {
  ToolHand hand(Tool::Select, three_discs());
  hand.view.selection = {kBack};
  hand.drag({300, 300}, {350, 300});
  expect_place(hand, kBack, {350, 300});
  expect_place(hand, kFront, {300, 300});
}

TEST(SelectTool, ShiftDragAddsTheLayerAndMovesBoth) {
  ToolHand hand(Tool::Select, three_discs());
  hand.view.selection = {kAside};
  hand.modifiers.is_shift = true;
  hand.drag({300, 300}, {340, 302});
  EXPECT_EQ(hand.view.selection, (Ids{kFront, kAside}));
  expect_place(hand, kFront, {340, 300});  // and along one axis
  expect_place(hand, kAside, {740, 700});
}

TEST(SelectTool, TheWayBackIsExact) {
  ToolHand hand(Tool::Select, three_discs());
  hand.press({700, 700});
  for (int i = 0; i < 50; ++i) hand.move({700.1 + 3.7 * i, 700.3 + i});
  auto const step = hand.release({700, 700});
  EXPECT_TRUE(step.commands.empty());
  EXPECT_EQ(hand.entries(), 0);
  EXPECT_FALSE(hand.was_refused());
}

TEST(SelectTool, ADragOnNothingDrawsABox) {
  ToolHand hand(Tool::Select, three_discs());
  hand.press({600, 600});
  hand.move({690, 690});
  EXPECT_TRUE(std::holds_alternative<ToolBoxing>(hand.state()));
  EXPECT_EQ(hand.view.selection, Ids{kAside});
  hand.move({610, 610});
  EXPECT_TRUE(hand.view.selection.empty());
  hand.release({100, 100});
  EXPECT_EQ(hand.view.selection, (Ids{kBack, kFront}));
  EXPECT_EQ(hand.entries(), 0);
}

TEST(SelectTool, ABoxWithShiftKeepsWhatWasSelected) {
  ToolHand hand(Tool::Select, three_discs());
  hand.view.selection = {kBack};
  hand.modifiers.is_shift = true;
  hand.drag({600, 600}, {690, 690});
  EXPECT_EQ(hand.view.selection, (Ids{kBack, kAside}));
}

TEST(SelectTool, ACancelledBoxGivesTheSelectionBack) {
  ToolHand hand(Tool::Select, three_discs());
  hand.view.selection = {kBack};
  hand.press({600, 600});
  hand.move({690, 690});
  hand.cancel();
  EXPECT_EQ(hand.view.selection, Ids{kBack});
}

TEST(SelectTool, InsideOfTheFrameTheSelectionIsHeldThoughNothingLiesThere) {
  ToolHand hand(Tool::Select, with_ring(empty_document(), {500, 500}, 200, 150));
  hand.view.selection = {kBack};
  hand.drag({500, 500}, {520, 500});
  expect_place(hand, kBack, {520, 500});
}

TEST(SelectTool, ACornerScalesFromTheOppositeOne) {
  ToolHand hand(Tool::Select, three_discs());
  hand.view.selection = {kAside};  // 650 .. 750
  hand.drag({750, 750}, {850, 800});
  auto const box = layer_box(*find_layer(hand.document(), kAside));
  EXPECT_NEAR(distance(box.min, {650, 650}), 0, 1e-9);
  EXPECT_NEAR(distance(box.max, {850, 800}), 0, 1e-9);
  EXPECT_EQ(hand.entries(), 1);
}

TEST(SelectTool, AnEdgeInAMirroredViewGoesAlongWithThePointer) {
  ToolHand hand(Tool::Select, three_discs());
  hand.view.selection = {kAside};
  hand.view.camera.is_mirrored = true;
  hand.drag({350, 700}, {300, 700});  // canvas 650 to 700
  auto const box = layer_box(*find_layer(hand.document(), kAside));
  EXPECT_NEAR(box.min.x, 700, 1e-9);
  EXPECT_NEAR(box.max.x, 750, 1e-9);
}

TEST(SelectTool, TheTurnHandleTurnsAboutTheCentre) {
  auto document = with_open(empty_document(), {line_stroke({{400, 500}, {600, 500}})});
  ToolHand hand(Tool::Select, document);
  hand.view.selection = {kBack};
  auto const frame = selection_frame(document, hand.view);
  ASSERT_TRUE(frame);
  auto const turn = frame->handles.back().second;
  hand.drag(turn, {500 + (500 - turn.y), 500});  // a quarter, clockwise on the screen
  auto const box = layer_box(*hand.document().layers->front());
  EXPECT_NEAR(box.width(), 0, 1e-6);
  EXPECT_NEAR(box.min.y, 400, 1e-6);
  EXPECT_NEAR(box.max.y, 600, 1e-6);
}

TEST(SelectTool, AltDragMovesACopyAndSelectsIt) {
  ToolHand hand(Tool::Select, three_discs());
  hand.modifiers.is_alt = true;
  hand.drag({700, 700}, {800, 700});
  ASSERT_EQ(hand.document().layers->size(), 4u);
  EXPECT_EQ(hand.view.selection, Ids{LayerId{4}});
  expect_place(hand, kAside, {700, 700});
  expect_place(hand, LayerId{4}, {800, 700});
  EXPECT_EQ(hand.entries(), 1);
}

TEST(SelectTool, ACancelledCopyIsGoneAndTheLayerSelected) {
  ToolHand hand(Tool::Select, three_discs());
  hand.modifiers.is_alt = true;
  hand.press({700, 700});
  hand.move({800, 700});
  hand.cancel();
  EXPECT_EQ(hand.document().layers->size(), 3u);
  EXPECT_EQ(hand.view.selection, Ids{kAside});
  EXPECT_EQ(hand.entries(), 0);
}

TEST(SelectTool, ADoubleClickDuplicates) {
  ToolHand hand(Tool::Select, three_discs());
  hand.click({300, 300});
  auto step = hand.click({300, 300}, 2);
  EXPECT_EQ(step.action, "duplicate_behind");
  EXPECT_EQ(step.argument, "2");
  hand.is_secondary = true;
  step = hand.click({300, 300}, 2);
  EXPECT_EQ(step.action, "duplicate_before");
  EXPECT_EQ(step.argument, "1");
}

TEST(SelectTool, OnlyEverySecondClickIsADoubleClick) {
  ToolHand hand(Tool::Select, three_discs());
  EXPECT_EQ(hand.click({700, 700}, 1).action, "");
  EXPECT_EQ(hand.click({700, 700}, 3).action, "");
  EXPECT_EQ(hand.click({700, 700}, 4).action, "duplicate_behind");
  EXPECT_EQ(hand.click({900, 100}, 2).action, "");
}

TEST(SelectTool, LockedLayersStayWhereTheyAre) {
  auto const document =
      with_changed(three_discs(), kAside, [](Layer& layer) { layer.is_locked = true; });
  ToolHand hand(Tool::Select, document);
  hand.view.selection = {kFront, kAside};
  hand.drag({300, 300}, {320, 300});
  expect_place(hand, kFront, {320, 300});
  expect_place(hand, kAside, {700, 700});
  EXPECT_FALSE(hand.was_refused());
}

TEST(SelectTool, HoverNamesTheNearestLayer) {
  ToolHand hand(Tool::Select, three_discs());
  hand.hover({300, 300});
  EXPECT_EQ(hand.view.hover, kFront);
}

}  // namespace
}  // namespace inkflate
