// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "document/apply.h"
#include "document/transform.h"
#include "pipeline/bend_session.h"
#include "support/bend_hand.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

/// out: the calls that it took
int prepare_all(BendHand& hand) {
  int calls = 0;
  for (; !hand.session.is_prepared(hand.document, hand.options) && calls < 100; ++calls) {
    hand.session.prepare(hand.document, hand.options);
  }
  return calls;
}

TEST(BendIdle, PreparingEnds) {
  BendHand hand(jointed_document());
  EXPECT_EQ(prepare_all(hand), 5);  // one for each part, and the joints
  hand.drag({kArm, {}, {}, kTipOfArm}, kTipOfArm + Vec2{-40, 120});
  EXPECT_FALSE(hand.session.is_prepared(hand.document, hand.options));
  EXPECT_EQ(prepare_all(hand), 4);  // what joins, the arm as it is now, its joints, and no more
  EXPECT_EQ(prepare_all(hand), 0);
}

TEST(BendIdle, WhatJoinsIsFoundInTheDocumentAsItLies) {
  BendHand hand(jointed_document());
  auto const begun = hand.document;
  for (bool const is_prepared : {false, true}) {
    EXPECT_TRUE(hand.session.is_limb(hand.document, kArm));
    EXPECT_FALSE(hand.session.is_limb(hand.document, kBody));
    hand.apply_all({DeleteLayers{{kBody}}});
    if (is_prepared) prepare_all(hand);
    EXPECT_FALSE(hand.session.is_limb(hand.document, kArm));
    EXPECT_TRUE(hand.session.is_limb(hand.document, kHand));
    hand.document = begun;
  }
}

TEST(BendIdle, IdleTimeChangesNothingToTheLastBit) {
  // Someone who waits after each step, and someone who never does.
  auto const eye = LayerId{5};
  BendHand patient(with_disc(jointed_document(), {400, 300}, 30));
  BendHand hasty(patient.document);
  auto const drag = [&](BendGrab const& what, Vec2 way) {
    for (auto* const hand : {&patient, &hasty}) {
      if (hand == &patient) prepare_all(*hand);
      hand->drag(what, what.place + way);
    }
    for (auto const layer : {kBody, kArm, kHand, kLeg, eye}) {
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
  drag({eye, {}, {}, {400, 270}}, {30, 20});
  drag(body_at(kTopOfBody + Vec2{70, 70}), {-60, -20});
}

TEST(BendIdle, WhatWasSeenAtIdleAloneIsForgotten) {
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

}  // namespace
}  // namespace inkflate
