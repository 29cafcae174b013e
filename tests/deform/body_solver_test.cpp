// SPDX-License-Identifier: Apache-2.0
#include "deform/body_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "geometry/trig.h"
#include "support/bend_meshes.h"

namespace inkflate {
namespace {

using support::anchor_near;
using support::bar_mesh;
using support::figure_mesh;
using support::largest_distance;
using support::nearest_vertex;
using support::side_by_side;

/// A handle that leaves its place where it is at rest, or takes it away by so much.
BendHandle handle(BendMesh const& mesh, BendAnchor const& anchor, Vec2 by = {}) {
  return {anchor, place_of(mesh.rest, mesh.rest.points, anchor) + by};
}

TEST(BodySolver, NothingMovesAtRest) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  EXPECT_TRUE(solver.step(pose, {}, 5).is_settled);
  EXPECT_EQ(pose, mesh.rest.points);
  std::vector<BendHandle> const pins = {handle(mesh, anchor_near(mesh, {680, 900})),
                                        handle(mesh, anchor_near(mesh, {900, 230}))};
  auto const progress = solver.step(pose, {pins, {}}, 5);
  EXPECT_TRUE(progress.is_settled);
  EXPECT_EQ(progress.largest_move_px, 0);
  EXPECT_LT(progress.energy, 1e-20);
  EXPECT_EQ(pose, mesh.rest.points);
}

TEST(BodySolver, ASingleHandleShiftsItsPieceWithoutTurningIt) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  Vec2 const by = {155, -40};
  std::vector<BendHandle> const one = {handle(mesh, anchor_near(mesh, {900, 230}), by)};
  auto const progress = solver.step(pose, {one, {}}, 1);
  EXPECT_TRUE(progress.is_settled);
  EXPECT_NEAR(progress.largest_move_px, norm(by), 1e-9);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    EXPECT_LT(distance(pose[v], mesh.rest.points[v] + by), 1e-9);
  }
  EXPECT_EQ(solver.step(pose, {one, {}}, 1).largest_move_px, 0);
}

TEST(BodySolver, SeveralHandlesAtOnePlaceShiftItsPieceToTheirMean) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  auto const hand = anchor_near(mesh, {900, 230});
  std::vector<BendHandle> const three = {handle(mesh, hand, {30, 0}), handle(mesh, hand, {0, 60}),
                                         handle(mesh, hand, {0, 0})};
  EXPECT_TRUE(solver.step(pose, {three, {}}, 3).is_settled);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    EXPECT_LT(distance(pose[v], mesh.rest.points[v] + Vec2{10, 20}), 1e-9);
  }
}

TEST(BodySolver, HandlesAtOnePlaceThatDisagreeByFarComeToRest) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  auto const hand = anchor_near(mesh, {900, 230});
  std::vector<BendHandle> const three = {handle(mesh, hand), handle(mesh, hand),
                                         handle(mesh, hand, {1e6, 0})};
  double before = solver.energy(pose, {three, {}});
  for (int i = 0; i < 10; ++i) {
    auto const progress = solver.step(pose, {three, {}}, 1);
    EXPECT_LE(progress.energy, before * (1 + 1e-11));
    before = progress.energy;
  }
  EXPECT_TRUE(solver.step(pose, {three, {}}, 1).is_settled);
}

TEST(BodySolver, FixedVerticesStayToTheLastBit) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<char> is_fixed;
  for (Vec2 const p : pose) is_fixed.push_back(p.y > 500);
  std::vector<BendHandle> const pull = {handle(mesh, anchor_near(mesh, {900, 230}), {-80, 250})};
  for (int i = 0; i < 5; ++i) solver.step(pose, {pull, is_fixed}, 2);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    if (!is_fixed[v]) continue;
    EXPECT_EQ(pose[v], mesh.rest.points[v]);
  }
  EXPECT_LT(distance(place_of(mesh.rest, pose, pull[0].anchor), pull[0].target), 0.5);
}

TEST(BodySolver, WhatIsTetheredGoesToWhereItsTethersAre) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  auto there = pose;
  for (auto& p : there) p += {30, -40};
  std::vector<double> const tethers(pose.size(), 0.5);
  BendHold const hold = {{}, {}, {}, tethers, there};
  EXPECT_NEAR(solver.energy(pose, hold), 0.5 * 50 * 50 * std::size(pose), 1e-6);
  solver.step(pose, hold, 5);
  EXPECT_LT(largest_distance(pose, there), 1e-3);
}

TEST(BodySolver, WithEveryVertexFixedNothingMoves) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<char> const is_fixed(pose.size(), true);
  std::vector<BendHandle> const pull = {handle(mesh, anchor_near(mesh, {900, 230}), {-80, 250})};
  EXPECT_TRUE(solver.step(pose, {pull, is_fixed}, 3).is_settled);
  EXPECT_EQ(pose, mesh.rest.points);
}

TEST(BodySolver, PiecesThatNothingHoldsStay) {
  auto const held = bar_mesh(200, 20, 20, 2);
  auto other = bar_mesh(100, 20, 10, 2);
  for (auto& p : other.rest.points) p += {0, 100};
  auto const mesh = side_by_side(held, other);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {handle(mesh, anchor_near(mesh, {0, 0})),
                                           handle(mesh, anchor_near(mesh, {200, 0}), {-60, 50})};
  for (int i = 0; i < 10; ++i) solver.step(pose, {handles, {}}, 2);
  EXPECT_GT(distance(pose[nearest_vertex(mesh.rest, {200, 0})], {200, 0}), 70);
  for (std::size_t v = held.rest.points.size(); v < pose.size(); ++v) {
    EXPECT_LT(distance(pose[v], mesh.rest.points[v]), 1e-9);
  }
}

TEST(BodySolver, WhatNothingHoldsAnyMoreRelaxesInPlace) {
  auto const mesh = bar_mesh(200, 40, 20, 4);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {handle(mesh, anchor_near(mesh, {0, 0})),
                                           handle(mesh, anchor_near(mesh, {100, 0}), {0, 40}),
                                           handle(mesh, anchor_near(mesh, {200, 0}))};
  for (int i = 0; i < 10; ++i) solver.step(pose, {handles, {}}, 2);
  auto const mean = [&] {
    Vec2 sum;
    for (Vec2 const p : pose) sum += p;
    return sum / static_cast<double>(pose.size());
  };
  Vec2 const before = mean();
  for (int i = 0; i < 20; ++i) solver.step(pose, {}, 5);
  EXPECT_LT(solver.energy(pose, {}), 1e-9);
  EXPECT_LT(distance(mean(), before), 1e-6);
  Vec2 const along = pose[nearest_vertex(mesh.rest, {200, 0})] - pose[0];
  EXPECT_NEAR(along.y / along.x, 0.1, 0.005);  // from the corner (0, -20) to (200, 0): not turned
}

TEST(BodySolver, ASettledPoseStaysToTheLastBit) {
  auto const mesh = figure_mesh(100);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {handle(mesh, anchor_near(mesh, {680, 900})),
                                           handle(mesh, anchor_near(mesh, {900, 230}), {-60, 100})};
  for (int i = 0; i < 30; ++i) solver.step(pose, {handles, {}}, 1);
  auto const settled = pose;
  EXPECT_TRUE(solver.step(pose, {handles, {}}, 10).is_settled);
  EXPECT_EQ(pose, settled);
}

TEST(BodySolver, SettledMeansNothingMovesAnyMoreThatOneCouldSee) {
  auto const mesh = figure_mesh(200);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {handle(mesh, anchor_near(mesh, {680, 900})),
                                           handle(mesh, anchor_near(mesh, {320, 900})),
                                           handle(mesh, anchor_near(mesh, {900, 230}), {-60, 300})};
  int steps = 0;
  while (!solver.step(pose, {handles, {}}, 1).is_settled) ASSERT_LT(++steps, 100);
  auto const settled = pose;
  for (int i = 0; i < 20; ++i) solver.step(pose, {handles, {}}, 1);
  EXPECT_LT(largest_distance(pose, settled), 0.01);
}

TEST(BodySolver, StepsThatAreTooShortAreMadeLonger) {
  auto const mesh = figure_mesh(150);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  // One foot is led across the other: the figure swings around that one, and a step that is not doubled goes a tiny bit of the way.
  std::vector<BendHandle> handles = {handle(mesh, anchor_near(mesh, {680, 900})),
                                     handle(mesh, anchor_near(mesh, {320, 900}), {400, 0})};
  for (auto& each : handles) each.grip_px = 30;
  int steps = 0;
  while (!solver.step(pose, {handles, {}}, 1).is_settled) ASSERT_LT(++steps, 200);
}

TEST(BodySolver, AHandleInsideATriangleHitsItsTargetWithinHalfAPixel) {
  auto const mesh = figure_mesh(200);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  auto inside = anchor_near(mesh, {850, 250});
  inside.weights = {0.2, 0.5, 0.3};
  std::vector<BendHandle> handles = {handle(mesh, anchor_near(mesh, {680, 900})),
                                     handle(mesh, anchor_near(mesh, {320, 900})),
                                     handle(mesh, inside)};
  for (int frame = 1; frame <= 20; ++frame) {
    handles[2] = handle(mesh, inside, Vec2{40, 200} * (frame / 20.0));
    solver.step(pose, {handles, {}}, 2);
    for (auto const& h : handles)
      EXPECT_LT(distance(place_of(mesh.rest, pose, h.anchor), h.target), 0.5);
  }
}

TEST(BodySolver, AHandleTurnsTheShapeAroundIt) {
  auto const mesh = bar_mesh(300, 30, 40, 4);
  for (double const turn : {0.4, -1.2, 3.14, 5.0}) {
    BodySolver solver(mesh);
    auto pose = mesh.rest.points;
    auto middle = handle(mesh, anchor_near(mesh, {150, 0}));
    middle.turn_rad = turn;
    std::vector<BendHandle> const handles = {handle(mesh, anchor_near(mesh, {0, 0})), middle};
    for (int i = 0; i < 20; ++i) solver.step(pose, {handles, {}}, 5);
    Vec2 const along =
        pose[nearest_vertex(mesh.rest, {157.5, 0})] - pose[nearest_vertex(mesh.rest, {142.5, 0})];
    auto const wanted = sin_cos(turn);
    Vec2 const direction = {wanted.cos, wanted.sin};
    EXPECT_GT(dot(normalized(along), direction), std::cos(0.1)) << turn;
    EXPECT_LT(distance(place_of(mesh.rest, pose, middle.anchor), middle.target), 0.5) << turn;
    EXPECT_TRUE(std::isfinite(solver.energy(pose, {handles, {}}))) << turn;
  }
}

TEST(BodySolver, AHandleThatOnlyTurnsTurnsAFreePieceWithoutBendingIt) {
  auto const mesh = bar_mesh(300, 30, 40, 4);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  auto end = handle(mesh, anchor_near(mesh, {0, 0}));
  end.turn_rad = kPi / 2;
  std::vector<BendHandle> const one = {end};
  for (int i = 0; i < 40; ++i) solver.step(pose, {one, {}}, 2);
  EXPECT_LT(solver.energy(pose, {one, {}}), 1e-9);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    EXPECT_LT(distance(pose[v], perpendicular(mesh.rest.points[v])), 1e-4);
  }
}

TEST(BodySolver, APoseThatIsTurnedOverStaysAsItIs) {
  auto const mesh = bar_mesh(100, 20, 10, 2);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  for (auto& p : pose) p.y = -p.y;
  auto const before = pose;
  auto const progress = solver.step(pose, {}, 3);
  EXPECT_TRUE(progress.is_settled);
  EXPECT_TRUE(std::isinf(progress.energy));
  EXPECT_EQ(pose, before);
}

TEST(BodySolver, ADrawingOfAnotherSizeBendsAlike) {
  auto const small = figure_mesh(100);
  auto large = small;
  for (auto& p : large.rest.points) p *= 8;
  large.edge_px *= 8;
  auto const bent = [](BendMesh const& mesh, double size) {
    BodySolver solver(mesh);
    auto pose = mesh.rest.points;
    std::vector<BendHandle> const handles = {
        handle(mesh, anchor_near(mesh, Vec2{680, 900} * size)),
        handle(mesh, anchor_near(mesh, Vec2{900, 230} * size), Vec2{-60, 150} * size)};
    for (int i = 0; i < 30; ++i) solver.step(pose, {handles, {}}, 1);
    return pose;
  };
  auto pose = bent(large, 8);
  for (auto& p : pose) p *= 1.0 / 8;
  EXPECT_LT(largest_distance(pose, bent(small, 1)), 1e-6);
}

TEST(BodySolver, BendsToTheSameBitsOnEveryMachine) {
  auto const mesh = bar_mesh(200, 30, 20, 4);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  auto middle = handle(mesh, anchor_near(mesh, {100, 0}), {10, 30});
  middle.turn_rad = 0.5;
  std::vector<BendHandle> const handles = {handle(mesh, anchor_near(mesh, {0, 0})), middle,
                                           handle(mesh, anchor_near(mesh, {200, 0}), {-40, 70})};
  solver.step(pose, {handles, {}}, 6);
  Hash hash;
  for (Vec2 const p : pose) {
    hash.add(p.x);
    hash.add(p.y);
  }
  EXPECT_EQ(hash.value(), 0x52708f7fd6f29303U) << std::hex << hash.value();
}

}  // namespace
}  // namespace inkflate
