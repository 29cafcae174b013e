// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "deform/body_solver.h"
#include "deform/step_bound.h"
#include "geometry/complex.h"
#include "geometry/trig.h"
#include "support/arap_body.h"
#include "support/bend_meshes.h"

namespace inkflate {
namespace {

using support::anchor_near;
using support::ArapBody;
using support::figure_mesh;
using support::largest_distance;

/// By 1.3 rad about the origin, and away.
Vec2 moved(Vec2 p) {
  auto const turn = sin_cos(1.3);
  return product(p, {turn.cos, turn.sin}) + Vec2{300, -80};
}

std::vector<BendHandle> moved_pins(BendMesh const& mesh) {
  std::vector<BendHandle> handles;
  for (Vec2 const place : {Vec2{680, 900}, Vec2{320, 900}, Vec2{500, 100}, Vec2{100, 230}}) {
    auto const anchor = anchor_near(mesh, place);
    handles.push_back({anchor, moved(place_of(mesh.rest, mesh.rest.points, anchor))});
  }
  return handles;
}

int turned_over(BendMesh const& mesh, BendPose const& pose) {
  auto const& triangles = mesh.rest.triangles;
  auto const is_turned = [&](Triangle const& corners) {
    Vec2 const a = pose[corners[0]];
    return !(cross(pose[corners[1]] - a, pose[corners[2]] - a) > 0);
  };
  return static_cast<int>(std::count_if(triangles.begin(), triangles.end(), is_turned));
}

/// A step towards where as-rigid-as-possible iterations go, by BodySolver's line search. False: it finds none.
bool step_within_wall(ArapBody const& body, BendMesh const& mesh, BendPose& pose) {
  auto moves = body.next(pose);
  for (std::size_t v = 0; v < pose.size(); ++v) moves[v] = moves[v] - pose[v];
  double const begun = body.energy(pose);
  double share = std::min(1.0, 0.9 * step_bound(mesh.rest.triangles, pose, moves));
  for (int i = 0; i < 40; ++i, share /= 2) {
    auto trial = pose;
    for (std::size_t v = 0; v < pose.size(); ++v) trial[v] += moves[v] * share;
    if (!(body.energy(trial) < begun) || turned_over(mesh, trial) > 0) continue;
    pose.swap(trial);
    return true;
  }
  return false;
}

/// Pins that move as one carry a shape along. All ways begin at rest, and have to come to this.
class Wall : public testing::Test {
 protected:
  double distance_left(BendPose const& pose) const {
    auto goal = mesh_.rest.points;
    for (auto& p : goal) p = moved(p);
    return largest_distance(pose, goal);
  }

  BendMesh mesh_ = figure_mesh(100);
  std::vector<BendHandle> handles_ = moved_pins(mesh_);
  BendPose pose_ = mesh_.rest.points;
};

TEST_F(Wall, AnEnergyWithoutOneTurnsTrianglesOverOnItsWay) {
  ArapBody const body(mesh_, handles_);
  int most = 0;
  for (int i = 0; i < 500; ++i) {
    pose_ = body.next(pose_);
    most = std::max(most, turned_over(mesh_, pose_));
  }
  EXPECT_LT(distance_left(pose_), 1);
  EXPECT_GT(most, 5);
}

TEST_F(Wall, AnEnergyWithoutOneJamsWhereTheLineSearchForbidsThat) {
  ArapBody const body(mesh_, handles_);
  for (int i = 0; i < 100; ++i) {
    if (!step_within_wall(body, mesh_, pose_)) break;
  }
  EXPECT_GT(distance_left(pose_), 500);
}

TEST_F(Wall, TheBodysEnergyComesThereWithinIt) {
  BodySolver solver(mesh_);
  for (int i = 0; i < 20; ++i) {
    solver.step(pose_, {handles_, {}}, 1);
    ASSERT_EQ(turned_over(mesh_, pose_), 0);
  }
  EXPECT_LT(distance_left(pose_), 1e-6);
}

}  // namespace
}  // namespace inkflate
