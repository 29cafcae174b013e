// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_document.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "document/apply.h"
#include "support/bend_hand.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

constexpr Vec2 kTop = {400, 190};
constexpr Vec2 kBottom = {400, 710};

ErrorCode refusal(std::vector<BendMove> const& moves, BendOptions const& options = {}) {
  auto const result = bend_document(jointed_document(), moves, options);
  EXPECT_FALSE(result.has_value());
  return result ? ErrorCode::FileSystem : result.error().code;
}

TEST(BendDocument, IsWhatAHandDoesWithPins) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottom}});
  hand.drag({kBody, {}, {}, kTop}, {560, 240});
  auto const bent =
      bend_document(jointed_document(), {{kBody, kTop, {560, 240}}, {kBody, kBottom, kBottom}});
  ASSERT_TRUE(bent.has_value());
  ASSERT_EQ(bent->commands.size(), 1);
  auto const result = inkflate::apply(jointed_document(), bent->commands);
  ASSERT_TRUE(result.has_value());
  for (auto const layer : {kBody, kArm, kHand, kLeg}) {
    EXPECT_LT(outline_distance(*result, hand.document, layer), 0.1) << static_cast<int>(layer);
  }
}

TEST(BendDocument, TellsWhereThePlacesHaveComeAndHowLongItTook) {
  auto const bent =
      bend_document(jointed_document(), {{kBody, kTop, {560, 240}}, {kBody, kBottom, kBottom}});
  ASSERT_TRUE(bent.has_value());
  ASSERT_EQ(bent->ends.size(), 2);
  EXPECT_LT(distance(bent->ends[0], {560, 240}), 1);
  EXPECT_LT(distance(bent->ends[1], kBottom), 1);
  EXPECT_GT(bent->steps, 0);
  EXPECT_TRUE(bent->is_settled);
}

TEST(BendDocument, AMoveThatBeginsAtAPinMovesThePin) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kTop}, {kBottom}});
  auto const bent = bend_document(hand.document, {{kBody, kTop, {450, 210}, 0.2}});
  ASSERT_TRUE(bent.has_value());
  ASSERT_EQ(bent->commands.size(), 2);
  auto const& pins = std::get<SetBendPins>(bent->commands[1]).pins;
  EXPECT_LT(distance(pins[0].position, {450, 210}), 1);
  EXPECT_NEAR(pins[0].turn_rad.value_or(0), 0.2, 1e-12);
  EXPECT_EQ(pins[1], BendPin{kBottom});
}

TEST(BendDocument, MovesOfLimbAndHostMeetInOneCommand) {
  auto const document = jointed_document();
  auto const bent =
      bend_document(document, {{kArm, {758.8, 330.3}, {700, 200}}, {kBody, kTop, {430, 190}}});
  ASSERT_TRUE(bent.has_value());
  ASSERT_EQ(bent->commands.size(), 1);
  EXPECT_EQ(std::get<Bend>(bent->commands[0]).parts.size(), 4);
}

TEST(BendDocument, FarTargetsGiveFiniteShapes) {
  auto const bent = bend_document(jointed_document(),
                                  {{kBody, kTop, {1500, -1200}}, {kBody, kBottom, {-1500, 5}}});
  ASSERT_TRUE(bent.has_value());
  for (auto const& part : std::get<Bend>(bent->commands[0]).parts) {
    for (auto const p : part.samples) EXPECT_TRUE(is_finite(p));
  }
}

TEST(BendDocument, RefusesWhatCannotBe) {
  double const infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal({}), ErrorCode::NothingThere);
  EXPECT_EQ(refusal({{kBody, kTop, kTop}}), ErrorCode::NothingThere);
  EXPECT_EQ(refusal({{LayerId{77}, kTop, kBottom}}), ErrorCode::BadInput);
  EXPECT_EQ(refusal({{kBody, kTop, {infinity, 0}}}), ErrorCode::BadInput);
  EXPECT_EQ(refusal({{kBody, kTop, kBottom}}, {BendMode::Body, 7}), ErrorCode::BadOption);
  auto const locked =
      with_changed(jointed_document(), kArm, [](Layer& layer) { layer.is_locked = true; });
  auto const result =
      bend_document(locked, {{kBody, kTop, kBottom}, {kArm, {700, 300}, {700, 200}}});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::BadInput);
  EXPECT_EQ(result.error().index, 1);
}

TEST(BendDocument, TellsItsStageAndStops) {
  std::string stage;
  int asked = 0;
  Progress const progress = {[&](std::string_view name) { stage = name; },
                             [&] { return ++asked > 2; }};
  auto const result = bend_document(
      jointed_document(), {{kBody, kTop, {700, 240}}, {kBody, kBottom, kBottom}}, {}, progress);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(stage, "bend");
}

}  // namespace
}  // namespace inkflate
