// SPDX-License-Identifier: Apache-2.0
#include "deform/rigid_freedom.h"

#include <gtest/gtest.h>

#include "support/bend_meshes.h"
#include "support/extremes.h"

namespace inkflate {
namespace {

using support::anchor_near;
using support::bar_mesh;
using support::largest_distance;
using support::side_by_side;

/// What a shift and a small turn about the origin would do.
std::vector<Vec2> rigid_moves(BendPose const& pose) {
  std::vector<Vec2> moves;
  for (Vec2 const p : pose) moves.push_back(Vec2{3, -2} + perpendicular(p) * 0.01);
  return moves;
}

double largest_norm(std::span<Vec2 const> moves) {
  double largest = 0;
  for (Vec2 const m : moves) largest = support::larger(largest, norm(m));
  return largest;
}

TEST(RigidFreedom, AMoveOfAFreePieceAsAWholeIsNoMove) {
  auto const mesh = bar_mesh(100, 20, 10, 2);
  RigidFreedom freedom(mesh);
  freedom.set_hold({});
  auto moves = rigid_moves(mesh.rest.points);
  freedom.remove_from(moves, mesh.rest.points);
  EXPECT_LT(largest_norm(moves), 1e-12);
}

TEST(RigidFreedom, APieceHeldAtOnePlaceKeepsItsShiftsAndLosesItsTurn) {
  auto const mesh = bar_mesh(100, 20, 10, 2);
  RigidFreedom freedom(mesh);
  std::vector<BendHandle> const one = {{anchor_near(mesh, {0, 0}), {0, 0}}};
  freedom.set_hold({one, {}});
  auto moves = rigid_moves(mesh.rest.points);
  freedom.remove_from(moves, mesh.rest.points);
  for (auto& m : moves) m -= {3, -2};
  EXPECT_LT(largest_norm(moves), 1e-12);
}

TEST(RigidFreedom, APieceHeldAtTwoPlacesOrByATurnKeepsItsMoves) {
  auto const mesh = bar_mesh(100, 20, 10, 2);
  RigidFreedom freedom(mesh);
  auto const moves = rigid_moves(mesh.rest.points);
  std::vector<BendHandle> const two = {{anchor_near(mesh, {0, 0}), {0, 0}},
                                       {anchor_near(mesh, {100, 0}), {0, 0}}};
  std::vector<BendHandle> const turned = {{anchor_near(mesh, {0, 0}), {0, 0}, 0.5}};
  std::vector<char> fixed(mesh.rest.points.size(), false);
  fixed[3] = fixed[4] = true;
  for (BendHold const& hold : {BendHold{two, {}}, BendHold{turned, {}}, BendHold{{}, fixed}}) {
    freedom.set_hold(hold);
    auto kept = moves;
    freedom.remove_from(kept, mesh.rest.points);
    EXPECT_EQ(kept, moves);
    auto pose = mesh.rest.points;
    freedom.shift_to_targets(pose);
    EXPECT_EQ(pose, mesh.rest.points);
  }
}

TEST(RigidFreedom, OnlyThePieceOfAHandleIsShiftedToIt) {
  auto const bar = bar_mesh(100, 20, 10, 2);
  auto other = bar;
  for (auto& p : other.rest.points) p += {0, 50};
  auto const mesh = side_by_side(bar, other);
  RigidFreedom freedom(mesh);
  std::vector<BendHandle> const one = {{anchor_near(mesh, {0, 50}), {7, 60}}};
  freedom.set_hold({one, {}});
  auto pose = mesh.rest.points;
  freedom.shift_to_targets(pose);
  auto expected = mesh.rest.points;
  for (std::size_t v = bar.rest.points.size(); v < expected.size(); ++v) expected[v] += {7, 10};
  EXPECT_LT(largest_distance(pose, expected), 1e-12);
}

TEST(RigidFreedom, APieceWithAFixedVertexIsNotShifted) {
  auto const mesh = bar_mesh(100, 20, 10, 2);
  RigidFreedom freedom(mesh);
  std::vector<BendHandle> const one = {{anchor_near(mesh, {0, 0}), {7, 60}}};
  std::vector<char> fixed(mesh.rest.points.size(), false);
  fixed[1] = true;  // the same place
  freedom.set_hold({one, fixed});
  auto pose = mesh.rest.points;
  freedom.shift_to_targets(pose);
  EXPECT_EQ(pose, mesh.rest.points);
}

}  // namespace
}  // namespace inkflate
