// SPDX-License-Identifier: Apache-2.0
#include "pipeline/laid_parts.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "document/apply.h"
#include "document/transform.h"
#include "support/bend_hand.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

constexpr LayerId kHead = LayerId{1};
constexpr LayerId kEye = LayerId{2};
constexpr LayerId kPupil = LayerId{3};

/// A head with an eye on it, on which a pupil lies.
Document face() {
  auto document = with_disc(empty_document(), {500, 500}, 200, "head");
  document = with_disc(document, {560, 420}, 50, "eye");
  return with_disc(document, {570, 420}, 20, "pupil");
}

std::vector<std::pair<LayerId, LayerId>> hosts(Document const& document,
                                               std::set<LayerId> const& joined = {}) {
  std::vector<std::pair<LayerId, LayerId>> pairs;
  for (auto const& laid : laid_parts(document, joined)) pairs.emplace_back(laid.part, laid.host);
  return pairs;
}

using Pairs = std::vector<std::pair<LayerId, LayerId>>;

TEST(LaidParts, LieOnTheTopmostOfThoseThatHaveMostOfThem) {
  EXPECT_EQ(hosts(face()), (Pairs{{kEye, kHead}, {kPupil, kEye}}));
  EXPECT_EQ(hosts(face(), {kPupil}), (Pairs{{kEye, kHead}}));
  // Nearly as large as the eye: on the head.
  auto const beside = with_disc(face(), {560, 420}, 49);
  EXPECT_EQ(hosts(beside, {kEye, kPupil}), (Pairs{{LayerId{4}, kHead}}));
}

TEST(LaidParts, LieThereWithATwelfthOfTheirRim) {
  auto const head = with_disc(empty_document(), {500, 500}, 200);
  EXPECT_EQ(hosts(with_disc(head, {730, 500}, 50)), (Pairs{{kEye, kHead}}));
  EXPECT_EQ(hosts(with_disc(head, {749, 500}, 50)), Pairs{});
  EXPECT_EQ(hosts(with_disc(head, {900, 500}, 50)), Pairs{});
  // Below it, but not in its hole.
  EXPECT_EQ(hosts(with_disc(with_disc(empty_document(), {500, 500}, 50), {500, 500}, 200)),
            (Pairs{{LayerId{1}, LayerId{2}}}));
  // A body is not carried by its own wing, nor a twin by its twin.
  EXPECT_EQ(hosts(with_disc(with_disc(empty_document(), {500, 500}, 150), {600, 500}, 200)),
            Pairs{});
  EXPECT_EQ(hosts(with_disc(head, {600, 500}, 200)), Pairs{});
  auto const ring = with_ring(empty_document(), {500, 500}, 200, 120);
  EXPECT_EQ(hosts(with_disc(ring, {500, 500}, 50)), Pairs{});
}

TEST(LaidParts, WhatIsSeenLiesOnWhatIsSeen) {
  auto const hide = [](Layer& layer) { layer.is_hidden = true; };
  EXPECT_EQ(hosts(with_changed(face(), kEye, hide)), (Pairs{{kEye, kHead}, {kPupil, kHead}}));
  EXPECT_EQ(hosts(with_changed(face(), kPupil, hide)), (Pairs{{kEye, kHead}, {kPupil, kEye}}));
  EXPECT_EQ(hosts(with_changed(face(), kHead, hide)), (Pairs{{kPupil, kEye}}));
}

TEST(LaidParts, HaveARimOfPlacesEvenlyAlongIt) {
  auto const laid = laid_parts(face(), {});
  ASSERT_EQ(laid.size(), 2U);
  auto const& rim = laid[0].rim;
  ASSERT_EQ(rim.size(), 48U);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    EXPECT_NEAR(distance(rim[i], rim[(i + 1) % rim.size()]), 2 * 3.14159 * 50 / 48, 0.3);
    EXPECT_NEAR(distance(rim[i], {560, 420}), 50, 0.3);
  }
}

/// The middle of a part's outer outline.
Vec2 middle_of(Document const& document, LayerId layer) {
  return bounds(flatten(layer_of_hand(document, layer).outlines.front(), 0.1)).centre();
}

constexpr Vec2 kTopOfHead = {500, 300};

/// Someone who has pinned the head's bottom.
BendHand with_pinned_head() {
  BendHand hand(face());
  hand.set_pins(kHead, {{{500, 700}}});
  return hand;
}

TEST(LaidParts, ComeAlongWithWhatTheyLieOnAndBack) {
  auto hand = with_pinned_head();
  auto const before = hand.document;
  hand.drag({kHead, {}, {}, kTopOfHead}, {640, 260});
  auto const way = middle_of(hand.document, kEye) - middle_of(before, kEye);
  EXPECT_GT(way.x, 60);
  EXPECT_LT(distance(middle_of(hand.document, kPupil) - middle_of(hand.document, kEye), {10, 0}),
            10);
  hand.drag({kHead, {}, {}, {640, 260}}, kTopOfHead);
  for (auto const part : {kHead, kEye, kPupil}) {
    EXPECT_EQ(outline_distance(before, hand.document, part), 0);
  }
}

TEST(LaidParts, KeepTheirShapeNearlyWhereTheHostIsSqueezed) {
  auto hand = with_pinned_head();
  hand.drag({kHead, {}, {}, kTopOfHead}, {500, 480});
  auto const contour = flatten(layer_of_hand(hand.document, kEye).outlines.front(), 0.1);
  auto const centre = bounds(contour).centre();
  // It has gone down, has no bumps and is about as round as it was.
  EXPECT_GT(centre.y, 450);
  for (auto const p : contour) EXPECT_NEAR(distance(p, centre), 50, 10);
  auto const disc_perimeter = 2 * 3.14159 * 50;
  EXPECT_NEAR(perimeter(contour), disc_perimeter, 0.05 * disc_perimeter);
}

TEST(LaidParts, AreFreeInAHandAndStayWhereTheyWereBrought) {
  auto hand = with_pinned_head();
  auto const before = hand.document;
  hand.drag({kEye, {}, {}, {560, 370}}, {440, 380});
  EXPECT_TRUE(is_shared(before, hand.document, kHead));
  EXPECT_LT(distance(middle_of(hand.document, kEye), {440, 430}), 0.1);
  EXPECT_LT(distance(middle_of(hand.document, kPupil), {450, 430}), 0.1);
  hand.drag({kHead, {}, {}, kTopOfHead}, kTopOfHead + Vec2{3, 0});
  EXPECT_LT(distance(middle_of(hand.document, kEye), {442, 430}), 2);
}

TEST(LaidParts, OnAHeadThatMovesAsAWholeMoveWithIt) {
  BendHand hand(face());
  hand.drag({kHead, {}, {}, kTopOfHead}, kTopOfHead + Vec2{120, -40});
  EXPECT_LT(distance(middle_of(hand.document, kEye), {680, 380}), 0.01);
  EXPECT_LT(distance(middle_of(hand.document, kPupil), {690, 380}), 0.01);
}

TEST(LaidParts, StayWhereTheyAreLocked) {
  BendHand hand(with_changed(face(), kEye, [](Layer& layer) { layer.is_locked = true; }));
  auto const before = hand.document;
  hand.drag({kHead, {}, {}, kTopOfHead}, kTopOfHead + Vec2{120, -40});
  EXPECT_TRUE(is_shared(before, hand.document, kEye));
  EXPECT_TRUE(is_shared(before, hand.document, kPupil));
}

TEST(LaidParts, LieWhereTheHeadIsPulledFromUnderThem) {
  auto hand = with_pinned_head();
  hand.apply_all({TransformLayers{{kEye, kPupil}, Affine::translation({300, 0})}});
  auto const before = hand.document;
  hand.drag({kHead, {}, {}, kTopOfHead}, {640, 260});
  EXPECT_TRUE(is_shared(before, hand.document, kEye));
}

}  // namespace
}  // namespace inkflate
