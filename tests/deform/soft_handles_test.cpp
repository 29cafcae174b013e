// SPDX-License-Identifier: Apache-2.0
#include "deform/soft_handles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/trig.h"
#include "support/bend_meshes.h"

namespace inkflate {
namespace {

using support::anchor_near;
using support::bar_mesh;
using support::side_by_side;

TEST(SoftHandles, APullIsASquareWithinItsReachAndAsSteepBeyond) {
  Pull const pull = {{}, {0, 0}, 3};
  EXPECT_EQ(pull_energy(pull, {0, 0}, 2), 0);
  EXPECT_EQ(pull_energy(pull, {3, 4}, 2), 75);
  EXPECT_NEAR(pull_energy(pull, {20, 0}, 2), 1200, 1e-10);
  EXPECT_NEAR(pull_energy(pull, {120, 0}, 2) - pull_energy(pull, {20, 0}, 2), 100 * 120, 1e-9);
  EXPECT_EQ(pull_gradient(pull, {3, 4}, 2), (Vec2{18, 24}));
  EXPECT_EQ(pull_gradient(pull, {20, 0}, 2), (Vec2{120, 0}));
  EXPECT_LT(distance(pull_gradient(pull, {400, 0}, 2), {120, 0}), 1e-12);
}

TEST(SoftHandles, GradientOfAPullIsTheDifferenceOfEnergies) {
  Pull const pull = {{}, {1, 2}, 3};
  for (Vec2 const place : {Vec2{4, -3}, Vec2{40, 25}}) {
    Vec2 const difference = {(pull_energy(pull, place + Vec2{1e-5, 0}, 2) -
                              pull_energy(pull, place - Vec2{1e-5, 0}, 2)) /
                                 2e-5,
                             (pull_energy(pull, place + Vec2{0, 1e-5}, 2) -
                              pull_energy(pull, place - Vec2{0, 1e-5}, 2)) /
                                 2e-5};
    EXPECT_LT(distance(pull_gradient(pull, place, 2), difference), 1e-5);
  }
}

TEST(SoftHandles, AHandleIsAsStrongAsTheStiffestTriangleWants) {
  auto mesh = bar_mesh(100, 20, 10, 2);
  mesh.stiffness[3] = 5;
  std::vector<BendHandle> const handles = {{anchor_near(mesh, {50, 0}), {60, 0}}};
  auto const pulls = SoftHandles(mesh, handles).pulls();
  ASSERT_EQ(pulls.size(), 1U);
  EXPECT_EQ(pulls[0].strength, 5 * SoftHandles::kStrength);
  EXPECT_EQ(pulls[0].target, (Vec2{60, 0}));
}

TEST(SoftHandles, ATurnPullsTheVerticesAroundToWhereTheyAreTurned) {
  auto const mesh = bar_mesh(100, 20, 10, 2);
  auto const centre = anchor_near(mesh, {50, 0});
  std::vector<BendHandle> const handles = {{centre, {60, 5}, kPi / 2}};
  auto const pulls = SoftHandles(mesh, handles).pulls();
  ASSERT_EQ(pulls.size(), 1U + 11U);  // three columns, and one on each side of them
  for (auto const& pull : pulls) {
    Vec2 const arm = place_of(mesh.rest, mesh.rest.points, pull.anchor) - Vec2{50, 0};
    EXPECT_LT(distance(pull.target, Vec2{60, 5} + perpendicular(arm)), 1e-9);
  }
}

TEST(SoftHandles, ATurnDoesNotReachAcrossAGap) {
  auto const bar = bar_mesh(100, 20, 10, 2);
  auto near = bar;
  for (auto& p : near.rest.points) p += {0, 20.5};
  auto const mesh = side_by_side(bar, near);
  std::vector<BendHandle> const handles = {{anchor_near(mesh, {50, 10}), {50, 10}, 1.0}};
  for (auto const& pull : SoftHandles(mesh, handles).pulls()) {
    EXPECT_LT(place_of(mesh.rest, mesh.rest.points, pull.anchor).y, 10.1);
  }
}

TEST(SoftHandles, ALargeTurnIsAskedForInPartsOnItsShorterWay) {
  auto const mesh = bar_mesh(100, 20, 10, 2);
  auto const centre = anchor_near(mesh, {50, 0});
  for (double const turn : {2.0, -2.0, 5.0}) {
    std::vector<BendHandle> const handles = {{centre, {50, 0}, turn}};
    auto const part = SoftHandles(mesh, handles).pulls_from(mesh.rest.points);
    double const asked = turn == 2.0 ? 0.5 : -0.5;
    auto const wanted = sin_cos(asked);
    for (auto const& pull : part) {
      Vec2 const arm = place_of(mesh.rest, mesh.rest.points, pull.anchor) - Vec2{50, 0};
      Vec2 const turned = {arm.x * wanted.cos - arm.y * wanted.sin,
                           arm.x * wanted.sin + arm.y * wanted.cos};
      EXPECT_LT(distance(pull.target, Vec2{50, 0} + turned), 1e-9) << turn;
    }
  }
}

}  // namespace
}  // namespace inkflate
