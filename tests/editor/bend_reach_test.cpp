// SPDX-License-Identifier: Apache-2.0
#include "editor/bend_reach.h"

#include <gtest/gtest.h>

#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr LayerId kBody{1};
constexpr LayerId kLimb{2};

/// A disc, and before it one whose left quarter is drawn by a help line.
Document body_and_limb() {
  auto document = with_disc(empty_document(), {300, 300}, 100);
  Layer limb;
  limb.name = "limb";
  limb.outlines = {circle_outline({400, 300}, 40)};
  limb.outlines[0].pieces[1].kind = RunKind::HelpLine;
  limb.outlines[0].pieces[2].kind = RunKind::HelpLine;
  return with_layer(document, limb, {});
}

double share_of(Document const& document, LayerId layer, ToolSettings const& settings = {}) {
  BendSession session;
  return bend_share(document, {layer, {}, {}, {400, 300}}, settings, session);
}

TEST(BendReach, OfWhatNothingHoldsIsAShareAndOfWhatIsHeldAll) {
  auto const document = body_and_limb();
  EXPECT_EQ(share_of(document, kBody), usual_bend_reach(BendMode::Body));
  EXPECT_EQ(share_of(document, kLimb), 1) << "its mouth holds it";
  auto const pinned = with_changed(document, kBody, [](Layer& layer) {
    layer.bend_pins = {{{200, 300}}};
  });
  EXPECT_EQ(share_of(pinned, kBody), 1);
}

TEST(BendReach, ThatWasSetCountsAlways) {
  ToolSettings settings;
  settings.bend_reach = 0.1;
  EXPECT_EQ(share_of(body_and_limb(), kBody, settings), 0.1);
  EXPECT_EQ(share_of(body_and_limb(), kLimb, settings), 0.1);
}

TEST(BendReach, IsMeasuredByTheLongerSideOfTheBox) {
  auto const document = body_and_limb();
  BendGrab const part = {kBody, {}, {}, {400, 300}};
  EXPECT_NEAR(*bend_reach(document, part, 0.3).px, 60, 0.1);
  EXPECT_FALSE(bend_reach(document, part, 1).px) << "the whole part";
}

TEST(BendReach, OfALineIsMeasuredByTheLine) {
  auto const document = with_loose(empty_document(), line_stroke({{100, 100}, {500, 100}}));
  BendGrab const line = {LayerId::None, StrokeRef{LayerId::None, 0}, {}, {300, 100}};
  BendSession session;
  EXPECT_EQ(bend_share(document, line, {}, session), usual_bend_reach(BendMode::Body));
  EXPECT_NEAR(*bend_reach(document, line, 0.5).px, 200, 1e-9);
}

TEST(BendReach, OfADotIsTheDot) {
  auto const document = with_loose(empty_document(), line_stroke({{100, 100}}));
  BendGrab const dot = {LayerId::None, StrokeRef{LayerId::None, 0}, {}, {100, 100}};
  EXPECT_FALSE(bend_reach(document, dot, 0.5).px);
}

}  // namespace
}  // namespace inkflate
