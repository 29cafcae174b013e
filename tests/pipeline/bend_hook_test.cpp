// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_hook.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "base/rng.h"
#include "geometry/affine.h"
#include "geometry/segment.h"
#include "geometry/trig.h"
#include "support/bend_meshes.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

constexpr std::array kPoints = {Vec2{0, 0}, Vec2{30, 5}, Vec2{10, 40}, Vec2{-7, 12}};

Affine turned_by(double rad, Vec2 shift) {
  auto const turn = sin_cos(rad);
  return {turn.cos, turn.sin, -turn.sin, turn.cos, shift.x, shift.y};
}

std::vector<Vec2> mapped(std::span<Vec2 const> points, Affine const& map) {
  std::vector<Vec2> result;
  for (Vec2 const p : points) result.push_back(map(p));
  return result;
}

TEST(BestMotion, IsTheOneThatMovedThePoints) {
  for (double const rad : {0.0, 0.3, -2.0, 3.1}) {
    auto const map = turned_by(rad, {120, -35});
    auto const motion = best_motion(kPoints, mapped(kPoints, map));
    for (Vec2 const p : kPoints) EXPECT_LT(distance(motion(p), map(p)), 1e-12 * 200);
    EXPECT_LT(distance(motion({1000, -500}), map({1000, -500})), 1e-9) << rad;
  }
}

TEST(BestMotion, OfAShiftIsThatShiftToTheLastBit) {
  auto const motion = best_motion(kPoints, kPoints);
  EXPECT_TRUE(motion.is_still());
  EXPECT_EQ(motion({0.1, 0.7}), (Vec2{0.1, 0.7}));
  RigidMotion const shift = {1, 0, {1, 1}, {4, 5}};
  EXPECT_FALSE(shift.is_still());
  EXPECT_EQ(shift({0.25, 0.5}), (Vec2{3.25, 4.5}));
}

TEST(BestMotion, OfPointsAtOnePlaceDoesNotTurn) {
  std::array const here = {Vec2{3, 3}, Vec2{3, 3}};
  std::array const there = {Vec2{8, 1}, Vec2{8, 1}};
  auto const motion = best_motion(here, there);
  EXPECT_EQ(motion({4, 4}), (Vec2{9, 2}));
  EXPECT_TRUE(best_motion({}, {}).is_still());
}

TEST(TurnAt, IsTheTurnOfThePoseFromRest) {
  auto const mesh = support::bar_mesh(200, 40, 20, 4);
  auto const at = support::anchor_near(mesh, {100, 0});
  for (double const rad : {0.0, 1.0, -3.0, 3.14}) {
    auto const pose = mapped(mesh.rest.points, turned_by(rad, {5, 6}));
    EXPECT_NEAR(turn_at(mesh, pose, at), rad, 1e-12);
  }
}

/// How far the triangles of a mesh are from a place, by its sides and corners; 0 inside.
double distance_to(BendMesh const& mesh, BendPose const& pose, Vec2 place) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const& t : mesh.rest.triangles) {
    bool is_in = true;
    for (int k = 0; k < 3; ++k) {
      Vec2 const a = pose[t[k]];
      Vec2 const b = pose[t[(k + 1) % 3]];
      is_in = is_in && cross(b - a, place - a) >= 0;
      least = std::min(least, distance(nearest_on_segment(place, a, b), place));
    }
    if (is_in) return 0;
  }
  return least;
}

TEST(HookAt, IsThePlaceItselfInThatPoseAndHangsOnTheNearestTriangle) {
  auto const mesh = support::bar_mesh(200, 40, 20, 4);
  auto const pose = support::posed(mesh.rest.points, support::arc_map(200, 0, 2));
  Rng rng(3);
  for (int k = 0; k < 200; ++k) {
    Vec2 const place = {rng.uniform(-100, 250), rng.uniform(-100, 250)};
    auto const hook = hook_at(mesh, pose, place);
    EXPECT_LT(distance(place_of(mesh, pose, hook), place), 1e-9);
    EXPECT_NEAR(norm(hook.beside), distance_to(mesh, pose, place), 1e-9);
  }
}

TEST(HookAt, GoesWithTheMeshInsideAndBesideItWhateverPoseItWasFoundIn) {
  auto const mesh = support::bar_mesh(200, 40, 20, 4);
  auto const found_in = mapped(mesh.rest.points, turned_by(1.2, {-50, 80}));
  auto const now = mapped(mesh.rest.points, turned_by(-0.7, {33, 7}));
  for (Vec2 const at_rest : {Vec2{77, 3}, Vec2{120, 31}, Vec2{-25, -30}}) {
    auto const hook = hook_at(mesh, found_in, turned_by(1.2, {-50, 80})(at_rest));
    EXPECT_LT(distance(place_of(mesh, now, hook), turned_by(-0.7, {33, 7})(at_rest)), 1e-9);
    EXPECT_LT(distance(place_of(mesh, mesh.rest.points, hook), at_rest), 1e-9);
  }
}

}  // namespace
}  // namespace inkflate
