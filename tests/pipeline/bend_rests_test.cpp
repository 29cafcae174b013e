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

/// out: the calls that it took
int prepare_all(BendHand& hand) {
  int calls = 0;
  for (; !hand.session.is_prepared(hand.document, hand.options) && calls < 100; ++calls) {
    hand.session.prepare(hand.document, hand.options);
  }
  return calls;
}

TEST(BendRests, PreparingEnds) {
  BendHand hand(jointed_document());
  EXPECT_EQ(prepare_all(hand), 5);  // one for each part, and the joints
  hand.drag({kArm, {}, {}, kTipOfArm}, kTipOfArm + Vec2{-40, 120});
  EXPECT_FALSE(hand.session.is_prepared(hand.document, hand.options));
  EXPECT_EQ(prepare_all(hand), 3);  // the arm as it is now, its joints, and no more
  EXPECT_EQ(prepare_all(hand), 0);
}

TEST(BendRests, IdleTimeChangesNothingToTheLastBit) {
  // Someone who waits after each step, and someone who never does.
  BendHand patient(jointed_document());
  BendHand hasty(jointed_document());
  auto const drag = [&](BendGrab const& what, Vec2 way) {
    for (auto* const hand : {&patient, &hasty}) {
      if (hand == &patient) prepare_all(*hand);
      hand->drag(what, what.place + way);
    }
    for (auto const layer : {kBody, kArm, kHand, kLeg}) {
      EXPECT_EQ(outline_distance(patient.document, hasty.document, layer), 0)
          << static_cast<int>(layer);
    }
  };
  auto const set = [&](Document const& document) {
    patient.document = hasty.document = document;
    prepare_all(patient);
  };
  auto const begun = hasty.document;
  patient.apply_all({TransformLayers{{kBody, kLeg}, Affine::scaling(0.4, 0.5)}});
  set(patient.document);
  set(begun);
  drag({kArm, {}, {}, kTipOfArm}, {-40, 120});
  drag(body_at({240, 450}), {10, 20});
  set(patient.document);
  hasty.set_pins(kBody, {{kBottomOfBody}});
  set(hasty.document);
  auto const pinned = hasty.document;
  drag(body_at(kTopOfBody), {90, 40});
  auto const bent = hasty.document;
  drag(body_at({250, 470}), {-30, 10});
  set(pinned);
  set(bent);
  drag(body_at(kTopOfBody + Vec2{90, 40}), {-20, 30});
  drag({kLeg, {}, {}, {460, 910}}, {70, -20});
  drag({kArm, {}, {}, {700, 450}}, {15, 60});
}

TEST(BendRests, WhatWasSeenAtIdleAloneIsForgotten) {
  BendHand patient(jointed_document());
  BendHand hasty(jointed_document());
  for (auto* const hand : {&patient, &hasty}) {
    hand->set_pins(kBody, {{kBottomOfBody}});
    hand->drag(body_at(kTopOfBody), {520, 220});
  }
  auto const bent = hasty.document;
  patient.apply_all({TransformLayers{{kBody}, Affine::scaling(0.5, 0.5)}});
  prepare_all(patient);
  patient.document = hasty.document = bent;
  patient.options.mode = BendMode::Wire;
  prepare_all(patient);
  patient.options = {};
  for (auto* const hand : {&patient, &hasty}) hand->drag(body_at({520, 220}), kTopOfBody);
  EXPECT_EQ(outline_distance(patient.document, hasty.document, kBody), 0);
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
