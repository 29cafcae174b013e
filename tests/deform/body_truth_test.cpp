// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "deform/body_solver.h"
#include "geometry/trig.h"
#include "support/bend_meshes.h"
#include "support/extremes.h"

namespace inkflate {
namespace {

using support::anchor_near;
using support::bar_mesh;
using support::figure_mesh;
using support::largest_distance;
using support::nearest_vertex;

/// Places of the figure that a person would hold.
constexpr std::array kFigurePins = {Vec2{680, 900}, Vec2{320, 900}, Vec2{500, 100}, Vec2{100, 230}};
constexpr Vec2 kFigureHand = {900, 230};

std::vector<BendHandle> pins_of(BendMesh const& mesh, std::span<Vec2 const> places) {
  std::vector<BendHandle> handles;
  for (Vec2 const place : places) {
    auto const anchor = anchor_near(mesh, place);
    handles.push_back({anchor, place_of(mesh.rest, mesh.rest.points, anchor)});
  }
  return handles;
}

/// Moves the last handle by so much in 20 frames of two steps, as a drag does.
void drag(BodySolver& solver, BendPose& pose, std::vector<BendHandle>& handles, Vec2 by) {
  Vec2 const from = handles.back().target;
  for (int frame = 1; frame <= 20; ++frame) {
    handles.back().target = from + by * (frame / 20.0);
    solver.step(pose, {handles, {}}, 2);
  }
}

void settle(BodySolver& solver, BendPose& pose, std::vector<BendHandle> const& handles) {
  for (int i = 0; i < 100; ++i) solver.step(pose, {handles, {}}, 1);
}

double area_of(BendPose const& pose, Triangle const& corners) {
  return cross(pose[corners[1]] - pose[corners[0]], pose[corners[2]] - pose[corners[0]]);
}

TEST(BodyTruth, PinsThatMoveAsOneCarryEverythingAlong) {
  auto const mesh = figure_mesh(150);
  auto const turn = sin_cos(1.3);
  auto const moved = [&](Vec2 p) {
    return Vec2{p.x * turn.cos - p.y * turn.sin, p.x * turn.sin + p.y * turn.cos} + Vec2{300, -80};
  };
  for (int const count : {2, 4}) {
    BodySolver solver(mesh);
    auto handles = pins_of(mesh, std::span(kFigurePins).first(count));
    for (auto& handle : handles) handle.target = moved(handle.target);
    auto pose = mesh.rest.points;
    settle(solver, pose, handles);
    EXPECT_LT(solver.energy(pose, {handles, {}}), 1e-10);
    for (std::size_t v = 0; v < pose.size(); ++v) {
      EXPECT_LT(distance(pose[v], moved(mesh.rest.points[v])), 1e-6);
    }
  }
}

TEST(BodyTruth, EnergyNeverRises) {
  auto const mesh = figure_mesh(150);
  BodySolver solver(mesh);
  auto handles = pins_of(mesh, kFigurePins);
  handles[0].target += {-200, -500};
  handles[3].target += {500, 150};
  auto pose = mesh.rest.points;
  double before = solver.energy(pose, {handles, {}});
  double const first = before;
  for (int i = 0; i < 80; ++i) {
    auto const progress = solver.step(pose, {handles, {}}, 1);
    EXPECT_LE(progress.energy, before * (1 + 1e-11));
    EXPECT_NEAR(progress.energy, solver.energy(pose, {handles, {}}), 1e-9 * before);
    before = progress.energy;
  }
  EXPECT_LT(before, 0.1 * first);
}

TEST(BodyTruth, TheMirrorImageBendsToTheMirrorImage) {
  auto const mesh = figure_mesh(150);
  auto mirrored = mesh;
  for (auto& p : mirrored.rest.points) p.x = 1000 - p.x;
  for (auto& corners : mirrored.rest.triangles) std::swap(corners[1], corners[2]);
  auto handles = pins_of(mesh, std::array{kFigurePins[0], kFigurePins[1], kFigureHand});
  handles[2].target += {-90, 180};
  auto mirrored_handles = handles;
  for (auto& handle : mirrored_handles) {
    std::swap(handle.anchor.weights[1], handle.anchor.weights[2]);
    handle.target.x = 1000 - handle.target.x;
  }
  auto pose = mesh.rest.points;
  auto mirrored_pose = mirrored.rest.points;
  BodySolver solver(mesh);
  BodySolver mirrored_solver(mirrored);
  settle(solver, pose, handles);
  settle(mirrored_solver, mirrored_pose, mirrored_handles);
  for (auto& p : mirrored_pose) p.x = 1000 - p.x;
  EXPECT_GT(largest_distance(pose, mesh.rest.points), 100);
  EXPECT_LT(largest_distance(pose, mirrored_pose), 1e-6);
}

TEST(BodyTruth, TheOrderOfVerticesDoesNotMatter) {
  auto const mesh = figure_mesh(150);
  auto const count = mesh.rest.points.size();
  auto reversed = mesh;
  std::reverse(reversed.rest.points.begin(), reversed.rest.points.end());
  for (auto& corners : reversed.rest.triangles) {
    for (auto& v : corners) v = static_cast<int>(count) - 1 - v;
  }
  auto handles = pins_of(mesh, std::array{kFigurePins[0], kFigurePins[1], kFigureHand});
  handles[2].target += {-90, 180};
  auto pose = mesh.rest.points;
  auto reversed_pose = reversed.rest.points;
  BodySolver solver(mesh);
  BodySolver reversed_solver(reversed);
  settle(solver, pose, handles);
  settle(reversed_solver, reversed_pose, handles);
  std::reverse(reversed_pose.begin(), reversed_pose.end());
  EXPECT_LT(largest_distance(pose, reversed_pose), 1e-6);
}

TEST(BodyTruth, AFinerMeshBendsAlike) {
  auto const bent_contour = [](int points) {
    auto const mesh = figure_mesh(points);
    BodySolver solver(mesh);
    auto handles = pins_of(mesh, std::array{kFigurePins[0], kFigurePins[1], kFigureHand});
    auto pose = mesh.rest.points;
    drag(solver, pose, handles, {60, 143});
    BendPose contour;
    for (int const v : mesh.lines[0].vertices) contour.push_back(pose[v]);
    return contour;
  };
  auto const coarse = bent_contour(300);
  auto const fine = bent_contour(600);
  double sum = 0;
  double largest = 0;
  for (int i = 0; i < 300; ++i) {
    double const apart = distance(coarse[i], fine[2 * i]);
    sum += apart;
    largest = support::larger(largest, apart);
  }
  EXPECT_LT(sum / 300, 2.5);
  EXPECT_LT(largest, 5);
}

TEST(BodyTruth, TwoStepsAFrameKeepADragAtTheMinimum) {
  for (double const inside : {1.0, 0.003}) {
    auto mesh = figure_mesh(200);
    std::vector<char> is_on_line(mesh.rest.points.size(), false);
    for (int const v : mesh.lines[0].vertices) is_on_line[v] = true;
    for (std::size_t t = 0; t < mesh.stiffness.size(); ++t) {
      auto const& [a, b, c] = mesh.rest.triangles[t];
      if (!is_on_line[a] && !is_on_line[b] && !is_on_line[c]) mesh.stiffness[t] = inside;
    }
    BodySolver solver(mesh);
    auto handles = pins_of(mesh, std::array{kFigurePins[0], kFigurePins[1], kFigureHand});
    auto pose = mesh.rest.points;
    drag(solver, pose, handles, {60, 143});
    auto minimum = pose;
    settle(solver, minimum, handles);
    EXPECT_LT(largest_distance(pose, minimum), 0.1) << inside;
  }
}

TEST(BodyTruth, DraggedOutAndBackEverythingIsWhereItWas) {
  auto const mesh = figure_mesh(200);
  BodySolver solver(mesh);
  auto handles = pins_of(mesh, std::array{kFigurePins[0], kFigurePins[1], kFigureHand});
  auto pose = mesh.rest.points;
  drag(solver, pose, handles, {100, 283});
  EXPECT_GT(largest_distance(pose, mesh.rest.points), 290);
  drag(solver, pose, handles, {-100, -283});
  EXPECT_LT(largest_distance(pose, mesh.rest.points), 0.1);
}

TEST(BodyTruth, APinAddedWhereItIsAndTakenAwayAgainChangesNothing) {
  auto const mesh = figure_mesh(200);
  BodySolver solver(mesh);
  auto handles = pins_of(mesh, std::array{kFigurePins[0], kFigurePins[1], kFigureHand});
  auto pose = mesh.rest.points;
  drag(solver, pose, handles, {60, 143});
  settle(solver, pose, handles);
  auto const before = pose;
  auto more = handles;
  auto const head = anchor_near(mesh, kFigurePins[2]);
  more.push_back({head, place_of(mesh.rest, pose, head)});
  solver.step(pose, {more, {}}, 5);
  EXPECT_EQ(pose, before);
  solver.step(pose, {handles, {}}, 5);
  EXPECT_EQ(pose, before);
}

TEST(BodyTruth, NoTriangleTurnsOverInAnyDrag) {
  auto const mesh = figure_mesh(120);
  for (int k = 0; k < 200; ++k) {
    Rng rng(k + 1);
    BodySolver solver(mesh);
    auto pose = mesh.rest.points;
    std::vector<BendHandle> handles;
    for (int pins = 1 + rng.below(5); pins >= 0; --pins) {
      BendAnchor anchor = {rng.below(static_cast<int>(mesh.rest.triangles.size())),
                           {0.2, 0.3, 0.5}};
      // Often at the same place, and so with different targets once one is dragged.
      if (rng.below(4) == 0 && !handles.empty()) anchor = handles.back().anchor;
      Vec2 const place = place_of(mesh.rest, pose, anchor);
      handles.push_back({anchor, place});
      if (rng.below(4) == 0) handles.back().turn_rad = rng.uniform(-7, 7);
    }
    double const reach_px = std::array{30.0, 300.0, 3000.0, 1e6}[rng.below(4)];
    drag(solver, pose, handles,
         {rng.uniform(-reach_px, reach_px), rng.uniform(-reach_px, reach_px)});
    for (auto const& corners : mesh.rest.triangles) {
      double const ratio = area_of(pose, corners) / area_of(mesh.rest.points, corners);
      ASSERT_GT(ratio, 0) << "drag " << k;
      ASSERT_TRUE(std::isfinite(ratio)) << "drag " << k;
    }
  }
}

TEST(BodyTruth, ABarThatIsPulledStretchesEvenly) {
  auto const mesh = bar_mesh(200, 40, 20, 4);
  constexpr double stretch = 1.6;
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<char> is_fixed;
  for (auto& p : pose) {
    bool const is_end = p.x == 200;
    is_fixed.push_back(p.x == 0 || is_end);
    // The ends are where they shall be, and all between them has been pulled near one end only.
    if (is_end) p.x = stretch * 200;
  }
  for (int i = 0; i < 50; ++i) solver.step(pose, {{}, is_fixed}, 1);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    EXPECT_LT(distance(pose[v], {mesh.rest.points[v].x * stretch, mesh.rest.points[v].y}), 1e-6);
  }
  double const density = std::pow(stretch - 1 / stretch, 2);
  EXPECT_NEAR(solver.energy(pose, {{}, is_fixed}), 200 * 40 * density, 1e-6);
}

TEST(BodyTruth, ABarThatASoftHandlePullsIsAsLongAsItsForcesSay) {
  auto const mesh = bar_mesh(200, 2, 200, 2);
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<char> is_fixed;
  for (auto const& p : pose) is_fixed.push_back(p.x == 0);
  std::vector<BendHandle> const pull = {{anchor_near(mesh, {200, 0}), {210, 0}}};
  for (int i = 0; i < 50; ++i) solver.step(pose, {pull, is_fixed}, 1);
  // The bar's force, width * d/ds (s - 1/s)^2, is that of the handle, 2 * 1000 * distance.
  auto const x_of = [&](double x) { return pose[nearest_vertex(mesh.rest, {x, 0})].x; };
  double const stretch = x_of(100) / 100;
  double const bar = 2 * 2 * (stretch - 1 / (stretch * stretch * stretch));
  double const handle = 2 * 1000 * (210 - x_of(200));
  EXPECT_NEAR(bar, handle, 1e-4 * handle);
  EXPECT_GT(handle, 0.1);
}

TEST(BodyTruth, ABarBendsUpwardsAsItBendsDownwards) {
  auto const mesh = bar_mesh(300, 40, 30, 4);
  std::vector<char> is_fixed;
  for (auto const& p : mesh.rest.points) is_fixed.push_back(p.x == 0);
  auto const bent = [&](double by) {
    BodySolver solver(mesh);
    auto pose = mesh.rest.points;
    std::vector<BendHandle> const pull = {{anchor_near(mesh, {300, 0}), {270, by}}};
    for (int i = 0; i < 50; ++i) solver.step(pose, {pull, is_fixed}, 1);
    return pose;
  };
  auto const down = bent(80);
  auto const up = bent(-80);
  constexpr int rows = 5;
  for (std::size_t v = 0; v < down.size(); ++v) {
    auto const column = v / rows * rows;
    auto const mirrored = column + (rows - 1 - v % rows);
    EXPECT_LT(distance(down[v], {up[mirrored].x, -up[mirrored].y}), 1e-6);
  }
}

}  // namespace
}  // namespace inkflate
