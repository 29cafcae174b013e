// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "document/apply.h"
#include "document/transform.h"
#include "support/bend_hand.h"
#include "support/characters.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

// What was bent lies on decimals.
constexpr double kGridPx = 1e-3;

TEST(BendSession, APartThatNothingHoldsMovesAsAWholeAndWhatHangsOnItToo) {
  BendHand hand(jointed_document());
  auto const before = hand.document;
  auto const commands = hand.drag(body_at(kTopOfBody), kTopOfBody + Vec2{120, -75});
  ASSERT_EQ(commands.size(), 1);
  for (auto const layer : {kBody, kArm, kHand, kLeg}) {
    auto const& old = layer_of_hand(before, layer).outlines.front().pieces;
    auto const& now = layer_of_hand(hand.document, layer).outlines.front().pieces;
    ASSERT_EQ(old.size(), now.size());
    for (std::size_t i = 0; i < old.size(); ++i) {
      auto const moved = old[i].curve.start() + Vec2{120, -75};
      EXPECT_LT(distance(now[i].curve.start(), moved), kGridPx);
    }
    auto const& stroke = find_layer(hand.document, layer)->strokes[0]->stroke;
    auto const& old_stroke = find_layer(before, layer)->strokes[0]->stroke;
    auto const moved = old_stroke.samples[1].position + Vec2{120, -75};
    EXPECT_LT(distance(stroke.samples[1].position, moved), kGridPx);
  }
}

TEST(BendSession, WhatWasBentLiesOnDecimalsAndWhatWasNotStaysToTheLastBit) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  std::set<std::pair<double, double>> old;
  for (auto const& piece : layer_of_hand(hand.document, kBody).outlines.front().pieces) {
    for (auto const p : piece.curve.control) old.insert({p.x, p.y});
  }
  hand.drag(body_at(kTopOfBody), {520, 220}, {300.0});
  int on_decimals = 0;
  int as_before = 0;
  int others = 0;  // of pieces that are cut where the reach ends
  for (auto const& piece : layer_of_hand(hand.document, kBody).outlines.front().pieces) {
    for (auto const p : piece.curve.control) {
      bool const is_decimal =
          p == Vec2{std::round(p.x * 1000) / 1000, std::round(p.y * 1000) / 1000};
      if (old.count({p.x, p.y}) > 0) {
        ++as_before;
      } else {
        ++(is_decimal ? on_decimals : others);
      }
    }
  }
  EXPECT_GT(on_decimals, 100);
  EXPECT_GT(as_before, 100);
  EXPECT_LE(others, 8);
}

TEST(BendSession, PinsHoldAndTheHeldPlaceGoesWithTheHand) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {{240, 450}}});
  hand.drag(body_at(kTopOfBody), {480, 150});
  auto const contour = flatten(layer_of_hand(hand.document, kBody).outlines.front(), 0.01);
  for (auto const held : {kBottomOfBody, Vec2{240, 450}, Vec2{480, 150}}) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < contour.size(); ++i) {
      least = std::min(least, squared_distance_to_segment(held, contour[i - 1], contour[i]));
    }
    EXPECT_LT(std::sqrt(least), 1) << held.x << " " << held.y;
  }
  EXPECT_EQ(layer_of_hand(hand.document, kBody).bend_pins[1].position, (Vec2{240, 450}));
}

TEST(BendSession, APlaceInsideIsHeldItself) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {{240, 450}}});
  BendGrab middle = body_at({400, 450});
  middle.is_inside = true;
  hand.drag(middle, {430, 440});
  // The stroke along the middle of the body has a sample there.
  auto const& document = hand.document;
  auto const& samples = find_layer(document, kBody)->strokes[0]->stroke.samples;
  EXPECT_LT(distance(samples[1].position, {430, 440}), 1);
}

TEST(BendSession, ADraggedPinStaysWhereItWasDraggedAndTheOthersStay) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {kTopOfBody}});
  auto const commands = hand.drag_pin(kBody, 1, {470, 200});
  ASSERT_EQ(commands.size(), 2);
  auto const& pins = std::get<SetBendPins>(commands[1]).pins;
  ASSERT_EQ(pins.size(), 2);
  EXPECT_EQ(pins[0].position, kBottomOfBody);
  EXPECT_LT(distance(pins[1].position, {470, 200}), 1e-9);
}

TEST(BendSession, TheOnlyPinTurnsThePartAsAWhole) {
  BendHand hand(jointed_document());
  hand.set_pins(kLeg, {{{460, 910}}});
  hand.apply_all({DeleteLayers{{kBody}}});
  auto const before = layer_of_hand(hand.document, kLeg).outlines.front().pieces;
  auto const commands = hand.drag_pin(kLeg, 0, {460, 910}, std::acos(0.0));
  ASSERT_EQ(commands.size(), 2);
  auto const pin = std::get<SetBendPins>(commands[1]).pins[0];
  EXPECT_EQ(pin.position, (Vec2{460, 910}));
  EXPECT_NEAR(pin.turn_rad.value_or(0), std::acos(0.0), 1e-12);
  auto const& after = layer_of_hand(hand.document, kLeg).outlines.front().pieces;
  // About the place of the outline that the pin holds, which is next to it.
  auto const old_way = before[20].curve.start() - before[0].curve.start();
  auto const way = after[20].curve.start() - after[0].curve.start();
  EXPECT_LT(distance(way, perpendicular(old_way)), 2 * kGridPx);
}

TEST(BendSession, ATurnedPinTurnsTheShapeAroundItAndCanBeTurnedBack) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}, {kTopOfBody}});
  auto const before = hand.document;
  hand.drag_pin(kBody, 1, kTopOfBody, 0.6);
  EXPECT_NEAR(layer_of_hand(hand.document, kBody).bend_pins[1].turn_rad.value_or(0), 0.6, 1e-12);
  EXPECT_GT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(before, kBody)), 3);
  hand.drag_pin(kBody, 1, kTopOfBody, -0.6);
  EXPECT_NEAR(layer_of_hand(hand.document, kBody).bend_pins[1].turn_rad.value_or(1), 0, 1e-12);
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kBody), layer_of_hand(before, kBody)),
            0.1);
}

TEST(BendSession, BeyondTheReachAllStaysAsItLies) {
  BendHand hand(jointed_document());
  auto const before = hand.document;
  hand.drag(body_at(kTopOfBody), kTopOfBody + Vec2{30, -60}, {150.0});
  auto const& old = layer_of_hand(before, kBody);
  auto const& now = layer_of_hand(hand.document, kBody);
  int stayed = 0;
  for (auto const& piece : old.outlines.front().pieces) {
    bool const is_there =
        std::find(now.outlines.front().pieces.begin(), now.outlines.front().pieces.end(), piece) !=
        now.outlines.front().pieces.end();
    if (piece.curve.start().y > 420 && piece.curve.end().y > 420) {
      EXPECT_TRUE(is_there);
      ++stayed;
    }
  }
  EXPECT_GT(stayed, 100);
  EXPECT_GT(contour_distance(now, old), 50);
  EXPECT_TRUE(is_shared(before, hand.document, kLeg));
}

TEST(BendSession, AnotherReachInTheMidstOfADragGivesWhatItWouldHaveGivenFromTheStart) {
  BendHand at_once(jointed_document());
  at_once.drag(body_at(kTopOfBody), {440, 150}, {180.0});
  BendHand changed(jointed_document());
  ASSERT_FALSE(changed.session.grab(changed.document, body_at(kTopOfBody), {}, {}));
  changed.session.drag({440, 150});
  changed.session.set_reach({180.0});
  changed.session.finish();
  changed.apply_all(changed.session.commands());
  EXPECT_LT(outline_distance(at_once.document, changed.document, kBody), 0.1);
}

TEST(BendSession, APlaceThatIsDraggedBackInAnotherGestureLeavesNoTraceWithinItsReach) {
  BendHand hand(jointed_document());
  auto const before = hand.document;
  Vec2 const there = kTopOfBody + Vec2{40, -120};
  hand.drag(body_at(kTopOfBody), there, {300.0});
  EXPECT_GT(outline_distance(before, hand.document, kBody), 100);
  hand.drag(body_at(there), kTopOfBody, {300.0});
  EXPECT_LT(outline_distance(before, hand.document, kBody), 0.01);
}

TEST(BendSession, AGestureThatGoesNowhereIsNoCommand) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  EXPECT_TRUE(hand.drag(body_at(kTopOfBody), kTopOfBody).empty());
  ASSERT_FALSE(hand.session.grab(hand.document, body_at(kTopOfBody), {}, {}));
  hand.session.drag({600, 300});
  hand.session.drag(kTopOfBody);
  hand.session.finish();
  EXPECT_TRUE(hand.session.commands().empty());
}

TEST(BendSession, ARoughStrokeMovesAsAWholeAndBendsWithinAReach) {
  auto const document =
      with_loose(jointed_document(), line_stroke({{100, 900}, {300, 900}, {500, 900}, {900, 900}}));
  BendHand hand(document);
  BendGrab const end = {LayerId::None, StrokeRef{LayerId::None, 0}, {}, {900, 900}};
  auto const commands = hand.drag(end, {930, 940});
  ASSERT_EQ(commands.size(), 1);
  EXPECT_EQ(std::get<Bend>(commands[0]).lines.size(), 1);
  auto const& moved = hand.document.loose[0]->stroke.samples;
  EXPECT_LT(distance(moved.front().position, {130, 940}), 1e-9);
  BendHand bent(document);
  bent.drag(end, {880, 960}, {300.0});
  auto const& samples = bent.document.loose[0]->stroke.samples;
  EXPECT_EQ(samples[0].position, (Vec2{100, 900}));
  EXPECT_EQ(samples[1].position, (Vec2{300, 900}));
  EXPECT_LT(distance(samples.back().position, {880, 960}), 1);
}

TEST(BendSession, ADragComesToRest) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  ASSERT_FALSE(hand.session.grab(hand.document, body_at(kTopOfBody), {}, {}));
  hand.session.drag({700, 300});
  EXPECT_FALSE(hand.session.is_settled());
  for (int i = 0; i < 100 && !hand.session.is_settled(); ++i) hand.session.settle();
  EXPECT_TRUE(hand.session.is_settled());
  auto const settled = hand.session.commands();
  hand.session.finish();
  hand.apply_all(settled);
  auto const document = hand.document;
  hand.document = jointed_document();
  hand.apply_all(hand.session.commands());
  EXPECT_EQ(outline_distance(document, hand.document, kBody), 0);
}

TEST(BendSession, AnySequenceOfCallsIsSafe) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  auto const document = jointed_document();
  BendSession session;
  session.drag({5, 5});
  session.settle();
  session.finish();
  session.set_reach({10.0});
  session.set_reach({1e-200});
  session.release(&document);
  session.forget();
  EXPECT_TRUE(session.commands().empty());
  EXPECT_TRUE(session.is_settled());
  EXPECT_TRUE(session.grab(document, {}, {}, {}).has_value());
  EXPECT_TRUE(session.grab(document, {LayerId{99}, {}, {}, {}}, {}, {}).has_value());
  EXPECT_TRUE(session.grab(document, {kBody, {}, 0, {}}, {}, {}).has_value());
  EXPECT_TRUE(session.grab(document, body_at({nan, 0}), {}, {}).has_value());
  for (double const reach : {-1.0, 0.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(session.grab(document, body_at(kTopOfBody), {reach}, {}).has_value()) << reach;
  }
  EXPECT_TRUE(session.grab(document, {LayerId::None, StrokeRef{kBody, 7}, {}, {}}, {}, {}));
  ASSERT_FALSE(session.grab(document, body_at(kTopOfBody), {}, {}).has_value());
  ASSERT_FALSE(session.grab(document, {kArm, {}, {}, kTipOfArm}, {}, {}).has_value());
  session.drag({nan, 3});
  session.drag({3, 3}, nan);
  session.drag({800, 500});
  session.release(&document);  // it did not come of these commands
  auto const other = with_disc(empty_document(), {300, 300}, 100);
  ASSERT_FALSE(session.grab(other, body_at({400, 300}), {50.0}, {}).has_value());
  session.drag({430, 300});
  session.set_reach({});
  EXPECT_FALSE(session.commands().empty());
  session.release(nullptr);
  ASSERT_FALSE(session.grab(document, body_at(kTopOfBody), {}, {}).has_value());
  session.forget();
  EXPECT_FALSE(session.is_holding());
}

}  // namespace
}  // namespace inkflate
