// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/editor_documents.h"
#include "support/tool_hand.h"

namespace inkflate {
namespace {

TEST(MarkTool, AClickMarksAPlaceAsOutside) {
  ToolHand hand(Tool::Mark, empty_document());
  auto const step = hand.click({120.5, 80});
  EXPECT_EQ(step.action, "mark_outside");
  EXPECT_EQ(step.argument, "120.5,80");
  EXPECT_TRUE(step.is_end);
}

TEST(MarkTool, AltOrTheSecondaryButtonMarksInside) {
  ToolHand hand(Tool::Mark, empty_document());
  hand.modifiers.is_alt = true;
  EXPECT_EQ(hand.click({10, 10}).action, "mark_inside");
  hand.modifiers = {};
  hand.is_secondary = true;
  EXPECT_EQ(hand.click({10, 10}).action, "mark_inside");
}

TEST(MarkTool, ThePlaceIsWhereItWasPressed) {
  ToolHand hand(Tool::Mark, empty_document());
  hand.view.camera.is_mirrored = true;
  hand.press({100, 100});
  EXPECT_EQ(hand.move({110, 100}).action, "");
  EXPECT_EQ(hand.release({115, 100}).argument, "900,100");
}

TEST(MarkTool, ACancelMarksNothing) {
  ToolHand hand(Tool::Mark, empty_document());
  hand.press({100, 100});
  EXPECT_EQ(hand.cancel().action, "");
}

TEST(MarkTool, HoverNamesTheLayerUnderIt) {
  ToolHand hand(Tool::Mark, with_disc(empty_document(), {500, 500}, 100));
  hand.hover({500, 500});
  EXPECT_EQ(hand.view.hover, LayerId{1});
}

}  // namespace
}  // namespace inkflate
