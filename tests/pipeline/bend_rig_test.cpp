// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "document/apply.h"
#include "geometry/segment.h"
#include "pipeline/bend_document.h"
#include "support/bend_hand.h"
#include "support/characters.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// How far a place is from the outer line of a part, px.
double off_the_line_px(Document const& document, LayerId layer, Vec2 place) {
  auto const contour = flatten(layer_of_hand(document, layer).outlines.front(), 0.01);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contour.size(); ++i) {
    Vec2 const near = nearest_on_segment(place, contour[i], contour[(i + 1) % contour.size()]);
    least = std::min(least, distance(near, place));
  }
  return least;
}

TEST(BendRig, APinThatHasNotComeToTheHandIsWhereItsPartIs) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {kTopOfBody}});
  ASSERT_FALSE(hand.session.grab(hand.document, {kBody, {}, 1, kTopOfBody}, {}, {}));
  // One frame is not enough for so long a way.
  hand.session.drag({5000, -3000});
  hand.apply_all(hand.session.commands());
  auto const& pins = layer_of_hand(hand.document, kBody).bend_pins;
  EXPECT_GT(distance(pins[1].position, {5000, -3000}), 1000);
  EXPECT_GT(distance(pins[1].position, kTopOfBody), 10);
  EXPECT_LT(off_the_line_px(hand.document, kBody, pins[1].position), 1);
  EXPECT_EQ(pins[0].position, kBottomOfBody);
}

TEST(BendRig, APinThatIsTurnedWhereThePartIsBentKeepsJustThatTurn) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {{240, 450}}, {kTopOfBody}});
  // The line at the pin turns with the bend, the pin itself is free to.
  hand.drag_pin(kBody, 2, {620, 300});
  hand.drag_pin(kBody, 2, {620, 300}, 0.3);
  auto const turned = layer_of_hand(hand.document, kBody);
  EXPECT_NEAR(turned.bend_pins[2].turn_rad.value_or(0), 0.3, 1e-12);
  hand.drag_pin(kBody, 0, kBottomOfBody + Vec2{1, 0});
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kBody), turned), 3);
}

TEST(BendRig, AJumpOfTheHandEndsWhereAWayInSmallStepsDoes) {
  BendHand slow(jointed_document());
  slow.set_pins(kBody, {{kBottomOfBody}, {{240, 450}}});
  BendHand fast(slow.document);
  slow.drag(body_at(kTopOfBody), {520, 260});
  ASSERT_FALSE(fast.session.grab(fast.document, body_at(kTopOfBody), {}, {}));
  fast.session.drag({520, 260});
  fast.session.finish();
  fast.apply_all(fast.session.commands());
  EXPECT_LT(
      contour_distance(layer_of_hand(slow.document, kBody), layer_of_hand(fast.document, kBody)),
      1);
}

TEST(BendRig, WhatNothingDrawsAtStaysHoweverUnsettledItWasLeft) {
  BendHand hand(jointed_document());
  hand.set_pins(kLeg, {{{460, 910}}});
  // Let go in the midst of a way: the leg would go on if it were asked to.
  ASSERT_FALSE(hand.session.grab(hand.document, {kLeg, {}, 0, {460, 910}}, {}, {}));
  hand.session.drag({700, 700});
  hand.apply_all(hand.session.commands());
  hand.session.release(&hand.document);
  auto const before = hand.document;
  ASSERT_FALSE(hand.session.grab(hand.document, body_at(kTopOfBody), {}, {}));
  hand.session.drag(kTopOfBody + Vec2{0, -30});
  hand.session.set_reach({100.0});
  hand.session.finish();
  hand.apply_all(hand.session.commands());
  EXPECT_FALSE(is_shared(before, hand.document, kBody));
  EXPECT_TRUE(is_shared(before, hand.document, kLeg));
}

TEST(BendRig, WhatHangsOnTwoPartsThatGoApartIsStretchedBetweenThem) {
  auto document = with_disc(empty_document(), {200, 500}, 100, "left");
  document = with_disc(document, {600, 500}, 100, "right");
  // A handle over both: it ends in their middles.
  document = with_layer(document, half_ring_layer("handle", {400, 500}, 170, 230, true),
                        {line_stroke({{200, 500}, {400, 300}, {600, 500}})});
  auto const id_of = [&](int index) { return (*document.layers)[index]->layer.id; };
  std::vector<BendMove> const moves = {{id_of(0), {100, 500}, {60, 520}},
                                       {id_of(1), {700, 500}, {750, 490}}};
  auto const bent = bend_document(document, moves);
  ASSERT_TRUE(bent) << bent.error().message;
  auto const after = inkflate::apply(document, bent->commands);
  ASSERT_TRUE(after);
  auto const& samples = find_layer(*after, id_of(2))->strokes[0]->stroke.samples;
  EXPECT_LT(distance(samples.front().position, {160, 520}), 3);
  EXPECT_LT(distance(samples.back().position, {650, 490}), 3);
}

}  // namespace
}  // namespace inkflate
