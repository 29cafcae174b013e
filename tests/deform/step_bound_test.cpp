// SPDX-License-Identifier: Apache-2.0
#include "deform/step_bound.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/rng.h"

namespace inkflate {
namespace {

constexpr std::array<Triangle, 1> kTriangle = {Triangle{0, 1, 2}};

double area_at(std::span<Vec2 const> pose, std::span<Vec2 const> moves, double t) {
  auto const at = [&](int v) { return pose[v] + moves[v] * t; };
  return cross(at(1) - at(0), at(2) - at(0));
}

TEST(StepBound, IsWhereACornerMeetsTheSideAcross) {
  std::array<Vec2, 3> const pose = {Vec2{0, 0}, Vec2{4, 0}, Vec2{1, 3}};
  std::array<Vec2, 3> const moves = {Vec2{0, 0}, Vec2{0, 0}, Vec2{1, -2}};
  EXPECT_NEAR(step_bound(kTriangle, pose, moves), 1.5, 1e-15);
}

TEST(StepBound, IsInfiniteWhereNothingIsPressed) {
  std::array<Vec2, 3> const pose = {Vec2{0, 0}, Vec2{4, 0}, Vec2{1, 3}};
  std::array<Vec2, 3> const shift = {Vec2{5, -3}, Vec2{5, -3}, Vec2{5, -3}};
  EXPECT_TRUE(std::isinf(step_bound(kTriangle, pose, shift)));
  EXPECT_TRUE(std::isinf(step_bound(kTriangle, pose, pose)));  // grows
}

TEST(StepBound, ATriangleThatShrinksToAPointDoesNotTurnOver) {
  std::array<Vec2, 3> const pose = {Vec2{0, 0}, Vec2{4, 0}, Vec2{1, 3}};
  std::array<Vec2, 3> const inwards = {-pose[0], -pose[1], -pose[2]};
  EXPECT_NEAR(step_bound(kTriangle, pose, inwards), 1, 1e-12);
}

TEST(StepBound, NothingHasTurnedOverBeforeItAndTheAreaIsZeroAtIt) {
  Rng rng(1);
  int finite = 0;
  for (int k = 0; k < 2000; ++k) {
    std::array<Vec2, 3> pose;
    std::array<Vec2, 3> moves;
    for (auto& p : pose) p = {rng.uniform(-1, 1), rng.uniform(-1, 1)};
    for (auto& m : moves) m = {rng.uniform(-1, 1), rng.uniform(-1, 1)};
    double const area = area_at(pose, moves, 0);
    if (area < 0.01) continue;
    double const bound = step_bound(kTriangle, pose, moves);
    EXPECT_GT(bound, 0);
    double const last = std::isfinite(bound) ? bound : 100;
    for (int i = 0; i < 50; ++i) EXPECT_GT(area_at(pose, moves, last * i / 50), 0);
    if (!std::isfinite(bound)) continue;
    ++finite;
    EXPECT_NEAR(area_at(pose, moves, bound), 0, 1e-10 * (1 + bound * bound));
  }
  EXPECT_GT(finite, 100);
}

TEST(StepBound, TheFirstOfManyTrianglesCounts) {
  std::array<Triangle, 2> const triangles = {Triangle{0, 1, 2}, Triangle{1, 3, 2}};
  std::array<Vec2, 4> const pose = {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}};
  std::array<Vec2, 4> const moves = {Vec2{0.5, 0.5}, Vec2{}, Vec2{}, Vec2{-1, -1}};
  EXPECT_NEAR(step_bound(triangles, pose, moves), 0.5, 1e-15);
}

}  // namespace
}  // namespace inkflate
