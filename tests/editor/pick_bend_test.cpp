// SPDX-License-Identifier: Apache-2.0
#include "editor/pick_bend.h"

#include <gtest/gtest.h>

#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr LayerId kBack{1};
constexpr LayerId kFront{2};
constexpr double kReachPx = 6;

std::optional<BendHit> pick(Document const& document, Vec2 place) {
  return pick_to_bend(document, place, kReachPx, PickDepth::Nearest);
}

TEST(PickBend, TheNearestOfTwoLinesThatCanBeSeenIsHeld) {
  // Side by side, 4 px apart.
  auto const document = with_disc(with_disc(empty_document(), {300, 300}, 100), {504, 300}, 100);
  EXPECT_EQ(pick(document, {401, 300})->what.layer, kBack);
  EXPECT_EQ(pick(document, {403, 300})->what.layer, kFront);
  EXPECT_TRUE(pick(document, {403, 300})->is_on_line);
}

TEST(PickBend, APlaceBesideEveryPartHoldsNothing) {
  auto const document = with_disc(empty_document(), {300, 300}, 100);
  EXPECT_TRUE(pick(document, {405, 300}));
  EXPECT_FALSE(pick(document, {407, 300}));
  EXPECT_FALSE(pick(empty_document(), {407, 300}));
}

TEST(PickBend, OfAnOpenPartOnlyTheLinesCanBeHeld) {
  auto const document = with_changed(with_disc(empty_document(), {300, 300}, 100), kBack,
                                     [](Layer& layer) { layer.is_open = true; });
  EXPECT_FALSE(pick(document, {300, 300}));
  auto const hit = pick(document, {400, 300});
  ASSERT_TRUE(hit && hit->what.stroke);
  EXPECT_EQ(hit->what.stroke->layer, kBack);
}

TEST(PickBend, ARoughLineLiesOverAllParts) {
  auto const document = with_loose(with_disc(empty_document(), {300, 300}, 100),
                                   line_stroke({{400, 200}, {400, 400}}));
  auto const hit = pick(document, {402, 300});
  ASSERT_TRUE(hit && hit->what.stroke);
  EXPECT_EQ(hit->what.place, (Vec2{400, 300}));
}

TEST(PickBend, OfTwoPinsAtOnePlaceTheOneInFrontIsHeld) {
  auto document = with_disc(with_disc(empty_document(), {300, 300}, 100), {300, 300}, 90);
  for (auto const layer : {kBack, kFront}) {
    document = with_changed(document, layer, [](Layer& changed) {
      changed.bend_pins = {{{300, 200}}};
    });
  }
  View const view;
  EXPECT_EQ(pick_pin(document, view, {304, 200}, 10), (BendPinRef{kFront, 0}));
  EXPECT_EQ(pick_pin(document, view, {304, 211}, 10), std::nullopt);
}

}  // namespace
}  // namespace inkflate
