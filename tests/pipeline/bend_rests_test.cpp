// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_rests.h"

#include <gtest/gtest.h>

#include "document/apply.h"
#include "document/transform.h"
#include "support/bend_hand.h"

namespace inkflate {
namespace {

TEST(BendRests, DraggingBackGivesTheShapeBack) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  auto const before = hand.document;
  auto const to = kTopOfBody + Vec2{210, 60};
  hand.drag(body_at(kTopOfBody), to);
  EXPECT_GT(contour_distance(layer_of_hand(before, kBody), layer_of_hand(hand.document, kBody)),
            50);
  EXPECT_GT(contour_distance(layer_of_hand(before, kHand), layer_of_hand(hand.document, kHand)),
            50);
  hand.drag(body_at(to), kTopOfBody);
  for (auto const layer : {kBody, kArm, kHand, kLeg}) {
    EXPECT_EQ(outline_distance(before, hand.document, layer), 0) << static_cast<int>(layer);
  }
}

TEST(BendRests, APinAddedAndRemovedIsNothing) {
  BendHand plain(jointed_document());
  plain.set_pins(kBody, {{kBottomOfBody}});
  BendHand pinned(plain.document);
  for (auto* const hand : {&plain, &pinned}) hand->drag(body_at(kTopOfBody), {520, 220});
  pinned.set_pins(kBody, {{kBottomOfBody}, {{300, 246}}});
  pinned.set_pins(kBody, {{kBottomOfBody}});
  for (auto* const hand : {&plain, &pinned}) hand->drag(body_at({520, 220}), {430, 260});
  EXPECT_EQ(outline_distance(plain.document, pinned.document, kBody), 0);
}

TEST(BendRests, AfterUndoADragGoesOnFromTheSameRest) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  auto const first = hand.document;
  hand.drag(body_at(kTopOfBody), {520, 220});
  auto const second = hand.document;
  hand.drag(body_at({520, 220}), {600, 300});
  hand.document = second;  // undo
  hand.drag(body_at({520, 220}), kTopOfBody);
  EXPECT_EQ(outline_distance(first, hand.document, kBody), 0);
  hand.document = second;  // undo and redo
  hand.drag(body_at({520, 220}), {300, 220});
  hand.document = first;
  auto const commands = hand.drag(body_at(kTopOfBody), {520, 220});
  EXPECT_EQ(outline_distance(second, hand.document, kBody), 0);
}

TEST(BendRests, WhatWasBentWithoutAPinStaysBentWhenAnotherPlaceIsTaken) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  hand.drag(body_at(kTopOfBody), {520, 220});
  auto const bent = hand.document;
  hand.drag(body_at({240, 450}), {241, 450});
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(bent, kBody)), 5);
  hand.drag_pin(kBody, 0, kBottomOfBody + Vec2{1, 0});
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(bent, kBody)), 5);
}

TEST(BendRests, ALimbThatWasBentStaysBentWhenItsHostMoves) {
  BendHand hand(jointed_document());
  hand.drag({kArm, {}, {}, kTipOfArm}, kTipOfArm + Vec2{-40, -120});
  auto const bent = layer_of_hand(hand.document, kArm);
  hand.drag(body_at(kTopOfBody), kTopOfBody + Vec2{30, 0});
  auto const moved = transformed(bent, Affine::translation({30, 0}));
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kArm), moved), 0.1);
}

TEST(BendRests, ALimbThatWasBentStaysBentWhenItsHostBends) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  auto const straight = layer_of_hand(hand.document, kArm);
  hand.drag({kArm, {}, {}, kTipOfArm}, kTipOfArm + Vec2{-40, -120});
  auto const bent = layer_of_hand(hand.document, kArm);
  EXPECT_GT(contour_distance(bent, straight), 50);
  hand.drag(body_at(kTopOfBody), kTopOfBody + Vec2{12, 0});
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kArm), bent), 20);
}

TEST(BendRests, ADocumentThatDidNotComeOfTheDragIsWhatItWas) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {kTopOfBody}});
  auto const before = hand.document;
  ASSERT_FALSE(hand.session.grab(before, {kBody, {}, 1, kTopOfBody}, {}, {}));
  hand.session.drag({600, 300});
  hand.session.finish();
  hand.session.release(&before);
  hand.drag_pin(kBody, 0, kBottomOfBody + Vec2{1, 0});
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(before, kBody)), 2);
}

TEST(BendRests, OnceForgottenTheBentShapeIsTheRest) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {{240, 450}}});
  auto const first = hand.document;
  hand.drag(body_at(kTopOfBody), {560, 260});
  hand.session.forget();
  hand.drag(body_at({560, 260}), kTopOfBody);
  EXPECT_GT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(first, kBody)),
            0.5);
}

TEST(BendRests, AChangedLayerBeginsANewRest) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  hand.drag(body_at(kTopOfBody), {520, 220});
  hand.apply_all({TransformLayers{{kBody}, Affine::scaling(0.5, 0.5)}});
  auto const scaled = hand.document;
  hand.drag(body_at({260, 110}), {300, 130});
  hand.drag(body_at({300, 130}), {260, 110});
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(scaled, kBody)),
            0.1);
}

TEST(BendRests, OtherStiffnessKeepsTheRestAndTheWireBeginsAnother) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  auto const first = hand.document;
  hand.drag(body_at(kTopOfBody), {520, 220});
  hand.options.body = 0.05;
  hand.drag(body_at({520, 220}), kTopOfBody);
  EXPECT_EQ(outline_distance(first, hand.document, kBody), 0);
  hand.options.mode = BendMode::Wire;
  hand.drag(body_at(kTopOfBody), {520, 220});
  EXPECT_GT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(first, kBody)), 20);
}

}  // namespace
}  // namespace inkflate
