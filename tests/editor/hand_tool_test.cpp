// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/tool_hand.h"

namespace inkflate {
namespace {

TEST(HandTool, ThePaperStaysUnderTheHand) {
  for (bool const is_mirrored : {false, true}) {
    ToolHand hand(Tool::Hand, empty_document());
    hand.view.camera = {{300, 400}, 2, is_mirrored};
    auto const held = to_canvas(hand.view.camera, hand.view.size, {100, 100});
    hand.drag({100, 100}, {220, 60});
    auto const now = to_canvas(hand.view.camera, hand.view.size, {220, 60});
    EXPECT_NEAR(distance(held, now), 0, 1e-9);
    EXPECT_EQ(hand.entries(), 0);
  }
}

TEST(HandTool, ResultsInNoCameraWhereNothingMoves) {
  ToolHand hand(Tool::Hand, empty_document());
  hand.press({100, 100});
  EXPECT_FALSE(hand.move({100, 100}).camera);
  EXPECT_FALSE(hand.release({100, 100}).camera);
}

}  // namespace
}  // namespace inkflate
