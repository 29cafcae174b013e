// SPDX-License-Identifier: Apache-2.0
#include "deform/bend_mesh.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

FlatMesh const kMesh = {{{0, 0}, {4, 0}, {0, 4}, {4, 4}}, {{0, 1, 2}, {1, 3, 2}}};

TEST(BendMesh, AnAnchorIsTheWeightedMeanOfItsCornersInAnyPose) {
  BendAnchor const anchor = {1, {0.5, 0.25, 0.25}};
  EXPECT_EQ(place_of(kMesh, kMesh.points, anchor), (Vec2{3, 2}));
  BendPose const pose = {{10, 0}, {20, 0}, {10, 40}, {20, 80}};
  EXPECT_EQ(place_of(kMesh, pose, anchor), (Vec2{17.5, 30}));
}

TEST(BendMesh, AnAnchorBesideItsTriangleHasANegativeWeight) {
  EXPECT_EQ(place_of(kMesh, kMesh.points, {0, {1.5, -0.25, -0.25}}), (Vec2{-1, -1}));
}

}  // namespace
}  // namespace inkflate
