// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "deform/bender.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using support::folded_limb_corners;
using support::polygon_outline;

Bender made(BendShape const& shape) {
  auto bender = Bender::make(shape);
  EXPECT_TRUE(bender.has_value());
  return std::move(*bender);
}

Polyline straight(Vec2 from, Vec2 to) {
  Polyline line;
  for (int k = 0; k <= 40; ++k) line.push_back(lerp(from, to, k / 40.0));
  return line;
}

TEST(BenderSheets, WhatLiesOverItselfIsBentAsItWasBeforeItDid) {
  // A body with a limb, whose tip is led back over the body.
  auto bender = made({{polygon_outline({{0, 0},
                                        {200, 0},
                                        {200, 140},
                                        {420, 140},
                                        {420, 180},
                                        {200, 180},
                                        {200, 200},
                                        {0, 200}})},
                      {}});
  auto const pins = [](Bender const& of, BendPose const& pose, Vec2 tip) {
    std::vector<BendHandle> handles;
    for (Vec2 const pin : {Vec2{0, 0}, Vec2{0, 200}, Vec2{200, 0}, Vec2{200, 200}, tip})
      handles.push_back({of.nearest(pose, pin), pin});
    return handles;
  };
  auto pose = bender.rest_pose();
  auto handles = pins(bender, pose, {420, 160});
  for (Vec2 const by : {Vec2{340, 40}, Vec2{240, 40}, Vec2{120, 80}}) {
    handles.back().target = by;
    bender.step(pose, {handles, {}, {}}, 30);
  }
  auto again = made({bender.bent(pose).outlines, {}});
  auto const pulled = [&](Bender& of, BendPose from) {
    auto held = pins(of, from, {120, 80});
    held.front().target = {60, 70};
    of.step(from, {held, {}, {}}, 50);
    return std::abs(signed_area(flatten(of.bent(from).outlines[0], 0.1)));
  };
  EXPECT_NEAR(pulled(again, again.rest_pose()), pulled(bender, pose), 1000);
}

TEST(BenderSheets, DetailsOfABodyStayWhenTheLimbOverThemMoves) {
  Polyline const body = straight({20, 60}, {180, 60});
  Polyline const limb = straight({280, 60}, {130, 60});
  auto bender = made({{polygon_outline(folded_limb_corners())}, {body, limb}});
  auto pose = bender.rest_pose();
  std::vector<BendHandle> handles;
  for (Vec2 const pin : {Vec2{0, 0}, Vec2{0, 200}, Vec2{200, 20}, Vec2{200, 200}})
    handles.push_back({bender.nearest(pose, pin), pin});
  handles.push_back({bender.nearest(pose, {120, 60}), {150, -40}});
  bender.step(pose, {handles, {}, {}}, 50);
  auto const bent = bender.bent(pose);
  for (std::size_t k = 0; k < body.size(); ++k)
    EXPECT_LT(distance(bent.lines[0][k], body[k]), 8) << k;
  EXPECT_GT(distance(bent.lines[1].back(), limb.back()), 80);
}

}  // namespace
}  // namespace inkflate
