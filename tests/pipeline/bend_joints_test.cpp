// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_joints.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/bend_hand.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

/// The mouth: the outline's only closing.
Polyline mouth_of(Document const& document, LayerId layer) {
  for (auto const& run : runs(layer_of_hand(document, layer).outlines.front(), 0.01)) {
    if (run.kind == RunKind::Closing) return run.points;
  }
  ADD_FAILURE() << "no mouth";
  return {{}, {}};
}

Vec2 middle_of_mouth(Document const& document, LayerId layer) {
  auto const mouth = mouth_of(document, layer);
  return lerp(mouth.front(), mouth.back(), 0.5);
}

TEST(BendJoints, LimbsStayWhereTheirHostHasThem) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  auto const before = hand.document;
  hand.drag(body_at(kTopOfBody), {580, 260});
  // A stroke of the body, drawn along the mouth, rides on the body's mesh.
  auto const& drawn = find_layer(hand.document, kBody)->strokes[1]->stroke.samples;
  auto const mouth = mouth_of(hand.document, kArm);
  for (auto const end : {mouth.front(), mouth.back()}) {
    EXPECT_LT(std::min(distance(end, drawn.front().position), distance(end, drawn.back().position)),
              0.5);
  }
  EXPECT_GT(distance(middle_of_mouth(before, kArm), middle_of_mouth(hand.document, kArm)), 20);
  // What nothing else holds keeps its shape nearly, over two joints.
  auto const length_of = [](Document const& document) {
    auto const& samples = find_layer(document, kHand)->strokes[0]->stroke.samples;
    return distance(samples.front().position, samples.back().position);
  };
  EXPECT_NEAR(length_of(hand.document), length_of(before), 0.01 * length_of(before));
}

TEST(BendJoints, LimbsStayThereWhenTheirHostGoesOnFromAnotherRest) {
  BendHand hand(jointed_document());
  hand.set_pins(kBody, {{kBottomOfBody}});
  hand.drag(body_at(kTopOfBody), {580, 260});
  auto const bent = hand.document;
  hand.drag(body_at({240, 450}), {241, 450});
  EXPECT_LT(distance(middle_of_mouth(bent, kArm), middle_of_mouth(hand.document, kArm)), 5);
  EXPECT_LT(contour_distance(layer_of_hand(hand.document, kArm), layer_of_hand(bent, kArm)), 10);
}

TEST(BendJoints, ALimbThatIsDraggedBendsFromItsMouthAndLeavesItsHostAlone) {
  BendHand hand(jointed_document());
  auto const before = hand.document;
  auto const commands = hand.drag({kArm, {}, {}, kTipOfArm}, kTipOfArm + Vec2{-40, 160});
  ASSERT_EQ(commands.size(), 1);
  EXPECT_EQ(std::get<Bend>(commands[0]).parts.size(), 2);  // the hand follows
  EXPECT_TRUE(is_shared(before, hand.document, kBody));
  EXPECT_TRUE(is_shared(before, hand.document, kLeg));
  EXPECT_LT(distance(middle_of_mouth(before, kArm), middle_of_mouth(hand.document, kArm)), 0.5);
  EXPECT_GT(distance(middle_of_mouth(before, kHand), middle_of_mouth(hand.document, kHand)), 100);
}

TEST(BendJoints, ALimbThatIsDraggedAwayFromItsHostStaysInOnePiece) {
  BendHand hand(jointed_document());
  hand.drag({kArm, {}, {}, kTipOfArm}, {5000, -3000});
  for (auto const& piece : layer_of_hand(hand.document, kArm).outlines.front().pieces) {
    for (auto const p : piece.curve.control) EXPECT_TRUE(is_finite(p));
  }
}

TEST(BendJoints, LockedPartsStayAndHiddenOnesFollow) {
  auto document = jointed_document();
  document = with_changed(document, kArm, [](Layer& layer) { layer.is_locked = true; });
  document = with_changed(document, kLeg, [](Layer& layer) { layer.is_hidden = true; });
  BendHand hand(document);
  hand.drag(body_at(kTopOfBody), {500, 190});
  EXPECT_TRUE(is_shared(document, hand.document, kArm));
  EXPECT_TRUE(is_shared(document, hand.document, kHand));
  EXPECT_NEAR(middle_of_mouth(hand.document, kLeg).x - middle_of_mouth(document, kLeg).x, 100,
              1e-9);
  EXPECT_TRUE(hand.session.grab(document, {kArm, {}, {}, kTipOfArm}, {}, {}).has_value());
  EXPECT_TRUE(hand.session.grab(document, {kLeg, {}, {}, {460, 910}}, {}, {}).has_value());
  EXPECT_FALSE(hand.session.is_holding());
}

TEST(BendJoints, ALimbThatHangsGoesAlongWithItsHostInTheSameFrame) {
  auto const document = jointed_document();
  BendHand hand(document);
  ASSERT_FALSE(hand.session.grab(document, {kArm, {}, {}, kTipOfArm}, {}, {}));
  // One jump of the mouse; the arm itself needs several frames for it.
  hand.session.drag(kTipOfArm + Vec2{-100, 250});
  hand.apply_all(hand.session.commands());
  EXPECT_GT(distance(middle_of_mouth(document, kHand), middle_of_mouth(hand.document, kHand)), 50);
  // The stroke of the hand begins in its mouth, that of the arm ends there.
  auto const gap_px = [](Document const& drawn) {
    auto const& arm = find_layer(drawn, kArm)->strokes[0]->stroke.samples;
    return distance(arm.back().position, middle_of_mouth(drawn, kHand));
  };
  EXPECT_NEAR(gap_px(hand.document), gap_px(document), 3);
}

/// The parts of a document, as they lie.
BendParts parts_of(Document const& document) {
  BendParts parts;
  for (auto const& layer : *document.layers) {
    parts[layer->layer.id] = std::make_shared<BendPart>(BendSource{layer, {}});
  }
  return parts;
}

TEST(BendJoints, AreFoundAnewWhereAPartIsNewAndStayElsewhere) {
  auto const document = jointed_document();
  auto parts = parts_of(document);
  for (auto& [layer, part] : parts) ASSERT_FALSE(part->make_ready({}));
  BendJoints joints;
  joints.meet(document, parts);
  joints.anchor(parts);
  ASSERT_EQ(joints.all().size(), 3U);
  parts[kHand] = std::make_shared<BendPart>(parts[kHand]->now().source);
  joints.meet(document, parts);
  ASSERT_EQ(joints.all().size(), 3U);
  for (auto const& joint : joints.all()) EXPECT_EQ(joint.anchors.empty(), joint.limb == kHand);
}

TEST(BendJoints, HostsGoBeforeTheirLimbs) {
  // The hand hangs on the arm, the arm and the leg on the body.
  auto const document = jointed_document();
  auto const parts = parts_of(document);
  BendJoints joints;
  joints.meet(document, parts);
  EXPECT_EQ(joints.all().size(), 3);
  EXPECT_EQ(hosts_first({kHand, kArm, kBody}, joints), (std::vector{kBody, kArm, kHand}));
  EXPECT_EQ(hanging_layers({kBody}, joints, {}), (std::vector{kArm, kLeg, kHand}));
  EXPECT_EQ(hanging_layers({kBody}, joints, {kArm}), std::vector{kLeg});
}

}  // namespace
}  // namespace inkflate
