// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "document/apply.h"
#include "editor/pick_bend.h"
#include "geometry/trig.h"
#include "support/editor_documents.h"
#include "support/sketches.h"
#include "support/tool_hand.h"

namespace inkflate {
namespace {

constexpr LayerId kBack{1};
constexpr LayerId kFront{2};
constexpr Vec2 kOnLine = {400, 300};  // of the front disc

/// One disc before another, around the same place.
Document two_discs() {
  return with_disc(with_disc(empty_document(), {300, 300}, 200), {300, 300}, 100);
}

Document with_pins(Document const& document, LayerId layer, std::vector<BendPin> const& pins) {
  return with_changed(document, layer, [&](Layer& changed) { changed.bend_pins = pins; });
}

/// What a press holds.
ToolPressedToBend pressed(ToolHand& hand, Vec2 place) {
  auto const step = hand.press(place);
  hand.release(place);
  return std::get<ToolPressedToBend>(step.state);
}

TEST(DeformTool, ADragOnTheLineTakesTheLineWithIt) {
  ToolHand hand(Tool::Deform, two_discs());
  hand.press(kOnLine + Vec2{3, 0});
  auto const step = hand.move({443, 310});
  ASSERT_TRUE(step.bend);
  EXPECT_EQ(step.bend->what.layer, kFront);
  EXPECT_FALSE(step.bend->what.pin);
  EXPECT_NEAR(distance(step.bend->what.place, kOnLine), 0, 0.1);
  // By as much as the hand has moved: what is held does not jump to the hand.
  EXPECT_NEAR(distance(step.bend->target, kOnLine + Vec2{40, 10}), 0, 0.1);
  EXPECT_FALSE(step.is_end);
  EXPECT_TRUE(hand.release({443, 310}).is_end);
}

TEST(DeformTool, APressInsideHoldsThatPlaceItself) {
  ToolHand hand(Tool::Deform, two_discs());
  auto const press = pressed(hand, {360, 300});
  EXPECT_EQ(press.on, BendPress::Inside);
  EXPECT_EQ(press.what.layer, kFront);
  EXPECT_TRUE(press.what.is_inside);
  EXPECT_EQ(press.what.place, (Vec2{360, 300}));
}

TEST(DeformTool, ALineUnderAnotherPartCannotBeHeldButWithTheSecondaryButton) {
  auto const document = with_disc(with_disc(empty_document(), {300, 300}, 50), {300, 300}, 100);
  ToolHand hand(Tool::Deform, document);
  EXPECT_EQ(pressed(hand, {350, 300}).what.layer, kFront);
  hand.is_secondary = true;
  EXPECT_EQ(pressed(hand, {350, 300}).what.layer, kBack);
}

TEST(DeformTool, AClickOnTheLinePutsAPinThere) {
  ToolHand hand(Tool::Deform, two_discs());
  auto const step = hand.click({402, 301});
  EXPECT_EQ(step.action, "add_pin");
  EXPECT_EQ(hand.view.selection, std::vector<LayerId>{kFront});
  EXPECT_FALSE(step.bend);
}

TEST(DeformTool, ATrembleIsAClick) {
  ToolHand hand(Tool::Deform, two_discs());
  hand.press(kOnLine);
  EXPECT_FALSE(hand.move(kOnLine + Vec2{2, 2}).bend);
  EXPECT_EQ(hand.release(kOnLine + Vec2{1, -1}).action, "add_pin");
}

TEST(DeformTool, AClickInsideSelectsThePartAndPutsNoPin) {
  ToolHand hand(Tool::Deform, two_discs());
  auto const step = hand.click({300, 300});
  EXPECT_TRUE(step.action.empty());
  EXPECT_EQ(hand.view.selection, std::vector<LayerId>{kFront});
}

TEST(DeformTool, AClickOnAPinSelectsItAndWithAltRemovesIt) {
  ToolHand hand(Tool::Deform, with_pins(two_discs(), kFront, {{{200, 300}}, {kOnLine}}));
  auto step = hand.click({403, 297});
  ASSERT_TRUE(step.pin);
  EXPECT_EQ(*step.pin, (BendPinRef{kFront, 1}));
  EXPECT_TRUE(step.action.empty());
  hand.modifiers.is_alt = true;
  step = hand.click(kOnLine);
  EXPECT_EQ(*step.pin, (BendPinRef{kFront, 1}));
  EXPECT_EQ(step.action, "delete");
}

TEST(DeformTool, AClickOnNothingSelectsNothing) {
  ToolHand hand(Tool::Deform, two_discs());
  hand.view.selection = {kFront};
  auto const step = hand.click({900, 900});
  ASSERT_TRUE(step.pin);
  EXPECT_FALSE(*step.pin);
  EXPECT_TRUE(hand.view.selection.empty());
}

TEST(DeformTool, ADragOnAPinMovesThePin) {
  ToolHand hand(Tool::Deform, with_pins(two_discs(), kFront, {{kOnLine}}));
  hand.press(kOnLine + Vec2{2, 2});
  auto const step = hand.move({452, 302});
  ASSERT_TRUE(step.bend);
  EXPECT_EQ(step.bend->what.pin, 0);
  EXPECT_EQ(step.bend->target, (Vec2{450, 300}));
  EXPECT_EQ(**step.pin, (BendPinRef{kFront, 0}));
}

TEST(DeformTool, AKnobTurnsThePinAsFarAsTheHandGoesAround) {
  ToolHand hand(Tool::Deform, with_pins(two_discs(), kFront, {{kOnLine}}));
  hand.view.pin = BendPinRef{kFront, 0};
  auto const knob = kOnLine - Vec2{0, kPinRingPx};
  hand.press(knob);
  std::optional<ToolBending> bend;
  // One and a quarter turn, clockwise on the screen.
  for (int i = 1; i <= 20; ++i) {
    auto const turn = sin_cos(i * kPi / 8);
    bend = hand.move(kOnLine + Vec2{turn.sin, -turn.cos} * 60).bend;
  }
  ASSERT_TRUE(bend && bend->turn_rad);
  EXPECT_NEAR(*bend->turn_rad, 2.5 * kPi, 1e-9);
  EXPECT_EQ(bend->target, kOnLine);
}

TEST(DeformTool, WithShiftAPinTurnsInSteps) {
  ToolHand hand(Tool::Deform, with_pins(two_discs(), kFront, {{kOnLine}}));
  hand.view.pin = BendPinRef{kFront, 0};
  hand.modifiers.is_shift = true;
  hand.press(kOnLine - Vec2{0, kPinRingPx});
  auto const turn = sin_cos(kPi / 12 + 0.05);
  auto const bend = hand.move(kOnLine + Vec2{turn.sin, -turn.cos} * kPinRingPx).bend;
  ASSERT_TRUE(bend && bend->turn_rad);
  EXPECT_NEAR(*bend->turn_rad, kPi / 12, 1e-9);
}

TEST(DeformTool, ALockedPartIsNotBentAndThatIsSaid) {
  auto const locked = with_changed(with_disc(empty_document(), {300, 300}, 100), kBack,
                                   [](Layer& layer) { layer.is_locked = true; });
  ToolHand hand(Tool::Deform, locked);
  EXPECT_EQ(hand.click(kOnLine).word, Word::PartLocked);
  hand.press(kOnLine);
  auto const step = hand.move({440, 300});
  EXPECT_EQ(step.word, Word::PartLocked);
  EXPECT_FALSE(step.bend);
}

TEST(DeformTool, ADragOnNothingIsSaidOnce) {
  ToolHand hand(Tool::Deform, two_discs());
  hand.press({900, 900});
  EXPECT_EQ(hand.move({920, 900}).word, Word::NothingToBend);
  EXPECT_FALSE(hand.move({940, 900}).word);
}

TEST(DeformTool, RoughLinesBendButTakeNoPins) {
  auto const document = with_loose(two_discs(), line_stroke({{250, 300}, {350, 300}}));
  ToolHand hand(Tool::Deform, document);
  EXPECT_EQ(hand.click({300, 302}).word, Word::NotYetPart);
  hand.press({300, 302});
  auto const step = hand.move({300, 340});
  ASSERT_TRUE(step.bend && step.bend->what.stroke);
  EXPECT_EQ(*step.bend->what.stroke, (StrokeRef{LayerId::None, 0}));
}

TEST(DeformTool, AFingerReachesFartherThanAMouse) {
  View view;
  view.tool = Tool::Deform;
  view.size = {1000, 1000};
  auto const document = two_discs();
  for (bool const is_finger : {false, true}) {
    ToolPointer pointer;
    pointer.canvas = pointer.screen = {410, 300};
    pointer.is_finger = is_finger;
    auto const step = tool_step(Tool::Deform, ToolIdle{}, ToolPress{pointer}, {document, view});
    auto const& press = std::get<ToolPressedToBend>(step.state);
    EXPECT_EQ(press.what.layer, is_finger ? kFront : kBack);
  }
}

TEST(DeformTool, WhatWouldBeHeldIsHovered) {
  ToolHand hand(Tool::Deform, two_discs());
  hand.hover({300, 300});
  EXPECT_EQ(hand.view.hover, kFront);
  hand.hover({900, 900});
  EXPECT_EQ(hand.view.hover, LayerId::None);
}

}  // namespace
}  // namespace inkflate
