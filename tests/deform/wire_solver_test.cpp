// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "deform/wire_edges.h"
#include "deform/wire_strip.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

Vec2 turned(Vec2 p, double angle_rad) {
  auto const [sin, cos] = sin_cos(angle_rad);
  return {cos * p.x - sin * p.y, sin * p.x + cos * p.y};
}

/// A bean: no symmetry, curved both ways.
Contour bean(int count, Vec2 centre = {}) {
  Contour contour;
  for (int i = 0; i < count; ++i) {
    double const angle_rad = 2 * kPi * i / count;
    double const radius_px =
        100 + 25 * sin_cos(2 * angle_rad).cos + 10 * sin_cos(3 * angle_rad).sin;
    contour.push_back(centre + turned({radius_px, 0}, angle_rad));
  }
  return contour;
}

BendMesh strip(int count = 40) {
  std::vector<Contour> const contours = {bean(count)};
  return wire_strip(contours, 8);
}

Vec2 at(BendAnchor const& anchor, BendMesh const& mesh, BendPose const& pose) {
  Vec2 sum;
  for (int k = 0; k < 3; ++k)
    sum += pose[mesh.rest.triangles[anchor.triangle][k]] * anchor.weights[k];
  return sum;
}

/// A handle at the middle of a triangle, moved from its rest.
BendHandle moved(BendMesh const& mesh, int triangle, Vec2 by) {
  BendAnchor const anchor = {triangle, {0.5, 0.2, 0.3}};
  return {anchor, at(anchor, mesh, mesh.rest.points) + by};
}

std::vector<BendHandle> three_handles(BendMesh const& mesh) {
  return {moved(mesh, 0, {}), moved(mesh, 13, {60, 20}), moved(mesh, 27, {-5, 30})};
}

double largest_distance(BendPose const& a, BendPose const& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, distance(a[i], b[i]));
  return largest;
}

/// The solution of a dense system, by elimination.
std::vector<Vec2> solved(std::vector<std::vector<double>> matrix, std::vector<Vec2> values) {
  auto const count = values.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < count; ++i)
      if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k])) pivot = i;
    std::swap(matrix[k], matrix[pivot]);
    std::swap(values[k], values[pivot]);
    for (std::size_t i = 0; i < count; ++i) {
      if (i == k) continue;
      double const factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k; j < count; ++j) matrix[i][j] -= factor * matrix[k][j];
      values[i] -= values[k] * factor;
    }
  }
  for (std::size_t k = 0; k < count; ++k) values[k] = values[k] / matrix[k][k];
  return values;
}

/// The first iteration from the rest pose, where all rotations are none, by a dense system with Lagrange multipliers.
BendPose first_by_elimination(BendMesh const& mesh, BendHold const& hold) {
  auto const vertices = mesh.rest.points.size();
  auto const fixed =
      static_cast<std::size_t>(std::count(hold.is_fixed.begin(), hold.is_fixed.end(), char{1}));
  auto const size = vertices + hold.handles.size() + fixed;
  std::vector<std::vector<double>> matrix(size, std::vector<double>(size, 0));
  std::vector<Vec2> values(size);
  for (auto const& [a, b, weight, rest] : wire_edges(mesh)) {
    matrix[a][a] += weight;
    matrix[b][b] += weight;
    matrix[a][b] -= weight;
    matrix[b][a] -= weight;
  }
  std::size_t row = vertices;
  for (auto const& handle : hold.handles) {
    for (int k = 0; k < 3; ++k) {
      int const v = mesh.rest.triangles[handle.anchor.triangle][k];
      matrix[row][v] = matrix[v][row] = handle.anchor.weights[k];
    }
    values[row++] = handle.target - at(handle.anchor, mesh, mesh.rest.points);
  }
  for (std::size_t v = 0; v < hold.is_fixed.size(); ++v) {
    if (hold.is_fixed[v] == 0) continue;
    matrix[row][v] = matrix[v][row] = 1;
    ++row;
  }
  auto pose = mesh.rest.points;
  auto const moves = solved(matrix, values);
  for (std::size_t v = 0; v < vertices; ++v) pose[v] += moves[v];
  return pose;
}

TEST(WireSolver, EqualsDirectElimination) {
  auto const mesh = strip();
  std::vector<char> is_fixed(mesh.rest.points.size(), 0);
  for (int v = 0; v < 10; ++v) is_fixed[v] = is_fixed[v + 40] = 1;
  auto const handles = three_handles(mesh);
  auto const without_first = std::span(handles).subspan(1);
  for (BendHold const hold : {BendHold{handles, {}}, BendHold{without_first, is_fixed}}) {
    WireSolver solver(mesh);
    auto pose = mesh.rest.points;
    solver.step(pose, hold, 1);
    EXPECT_LT(largest_distance(pose, first_by_elimination(mesh, hold)), 1e-8);
  }
}

TEST(WireSolver, EnergyNeverRisesOnceTheHandlesAreMet) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  auto const handles = three_handles(mesh);
  double before = solver.step(pose, {handles, {}}, 1).energy;
  for (int i = 0; i < 200; ++i) {
    double const after = solver.step(pose, {handles, {}}, 1).energy;
    EXPECT_LE(after, before * (1 + 1e-12));
    before = after;
  }
}

TEST(WireSolver, MeetsHandlesExactly) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  auto handles = three_handles(mesh);
  handles.push_back({{50, {1, 0, 0}}, {300, 300}});
  handles.push_back({{90, {-0.2, 0.7, 0.5}}, {-300, 10}});
  solver.step(pose, {handles, {}}, 3);
  for (auto const& handle : handles)
    EXPECT_LT(distance(at(handle.anchor, mesh, pose), handle.target), 1e-8);
}

TEST(WireSolver, HandlesThatMoveRigidlyCarryAllWithThem) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto const rigid = [](Vec2 p) { return turned(p, 1.3) + Vec2{40, -70}; };
  std::vector<BendHandle> handles;
  for (int const triangle : {0, 13, 27}) {
    handles.push_back(moved(mesh, triangle, {}));
    handles.back().target = rigid(handles.back().target);
  }
  auto pose = mesh.rest.points;
  auto const progress = solver.step(pose, {handles, {}}, 20000);
  BendPose wanted;
  for (auto const p : mesh.rest.points) wanted.push_back(rigid(p));
  EXPECT_LT(largest_distance(pose, wanted), 1e-6);
  EXPECT_LT(progress.energy, 1e-10);
  EXPECT_TRUE(progress.is_settled);
}

TEST(WireSolver, OneHandleShiftsAll) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 5, {30, 40})};
  solver.step(pose, {handles, {}}, 5);
  for (std::size_t v = 0; v < pose.size(); ++v)
    EXPECT_LT(distance(pose[v], mesh.rest.points[v] + Vec2{30, 40}), 1e-9);
}

TEST(WireSolver, NothingMovesWithoutHandles) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto bent = mesh.rest.points;
  solver.step(bent, {three_handles(mesh), {}}, 5);
  auto pose = bent;
  EXPECT_TRUE(solver.step(pose, {}, 5).is_settled);
  EXPECT_EQ(pose, bent);
}

TEST(WireSolver, HandlesAtTheirRestLeaveTheRestPose) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 5, {}), moved(mesh, 50, {})};
  EXPECT_TRUE(solver.step(pose, {handles, {}}, 5).is_settled);
  EXPECT_LT(largest_distance(pose, mesh.rest.points), 1e-10);
}

TEST(WireSolver, AHandleAddedAndRemovedIsNothing) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  WireSolver other(mesh);
  auto const handles = three_handles(mesh);
  std::vector<BendHandle> const more = {handles[0], moved(mesh, 90, {9, 9}), handles[2]};
  auto pose = mesh.rest.points;
  solver.step(pose, {more, {}}, 3);
  solver.step(pose, {handles, {}}, 1);
  pose = mesh.rest.points;
  auto same = pose;
  solver.step(pose, {handles, {}}, 10);
  other.step(same, {handles, {}}, 10);
  EXPECT_EQ(pose, same);
}

TEST(WireSolver, TheSameTwiceGivesTheSameBits) {
  auto const mesh = strip();
  auto const handles = three_handles(mesh);
  BendPose poses[2] = {mesh.rest.points, mesh.rest.points};
  for (auto& pose : poses) {
    WireSolver solver(mesh);
    solver.step(pose, {handles, {}}, 30);
  }
  EXPECT_EQ(poses[0], poses[1]);
}

TEST(WireSolver, AMirroredMeshBendsAsItsMirrorImage) {
  auto const mesh = strip();
  auto mirrored = mesh;
  for (auto& p : mirrored.rest.points) p.x = -p.x;
  for (auto& [a, b, c] : mirrored.rest.triangles) std::swap(b, c);
  auto handles = three_handles(mesh);
  auto pose = mesh.rest.points;
  WireSolver(mesh).step(pose, {handles, {}}, 50);
  for (auto& handle : handles) {
    handle.target.x = -handle.target.x;
    std::swap(handle.anchor.weights[1], handle.anchor.weights[2]);
  }
  auto mirror_pose = mirrored.rest.points;
  WireSolver(mirrored).step(mirror_pose, {handles, {}}, 50);
  for (auto& p : mirror_pose) p.x = -p.x;
  EXPECT_LT(largest_distance(pose, mirror_pose), 1e-8);
}

TEST(WireSolver, WhatIsFixedStaysToTheBit) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  std::vector<char> is_fixed(mesh.rest.points.size(), 0);
  for (std::size_t v = 0; v < 20; ++v) is_fixed[v] = is_fixed[v + 40] = is_fixed[v + 80] = 1;
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 30, {50, -20})};
  solver.step(pose, {handles, is_fixed}, 50);
  double moved_px = 0;
  for (std::size_t v = 0; v < pose.size(); ++v) {
    if (is_fixed[v] != 0) {
      EXPECT_EQ(pose[v], mesh.rest.points[v]);
    }
    moved_px = std::max(moved_px, distance(pose[v], mesh.rest.points[v]));
  }
  EXPECT_GT(moved_px, 40);
  EXPECT_LT(distance(at(handles[0].anchor, mesh, pose), handles[0].target), 1e-8);
}

TEST(WireSolver, AHandleInsideOfWhatIsFixedDoesNotCount) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  std::vector<char> const is_fixed(mesh.rest.points.size(), 1);
  auto pose = mesh.rest.points;
  solver.step(pose, {three_handles(mesh), is_fixed}, 5);
  EXPECT_EQ(pose, mesh.rest.points);
}

TEST(WireSolver, ATurnedHandleTurnsItsTriangle) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> handles = {moved(mesh, 0, {}), moved(mesh, 20, {10, 20})};
  handles[1].turn_rad = 0.7;
  solver.step(pose, {handles, {}}, 20);
  EXPECT_LT(distance(at(handles[1].anchor, mesh, pose), handles[1].target), 1e-8);
  auto const [a, b, c] = mesh.rest.triangles[20];
  auto const& rest = mesh.rest.points;
  EXPECT_LT(distance(pose[b] - pose[a], turned(rest[b] - rest[a], 0.7)), 1e-8);
  EXPECT_LT(distance(pose[c] - pose[a], turned(rest[c] - rest[a], 0.7)), 1e-8);
}

TEST(WireSolver, AStripWithoutAHandleStaysWhereItIs) {
  std::vector<Contour> const contours = {bean(40), bean(20, {400, 0})};
  auto const mesh = wire_strip(contours, 6);
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  solver.step(pose, {three_handles(mesh), {}}, 20);
  for (std::size_t v = 0; v < pose.size(); ++v) {
    bool const is_at_rest = pose[v] == mesh.rest.points[v];
    EXPECT_EQ(is_at_rest, v >= 120);
  }
}

TEST(WireSolver, EachOfSeveralStripsFollowsItsOwnHandles) {
  std::vector<Contour> const contours = {bean(40), bean(20, {400, 0})};
  auto const mesh = wire_strip(contours, 6);
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 0, {10, 0}), moved(mesh, 170, {0, 20})};
  solver.step(pose, {handles, {}}, 5);
  for (std::size_t v = 0; v < pose.size(); ++v)
    EXPECT_LT(distance(pose[v], mesh.rest.points[v] + (v < 120 ? Vec2{10, 0} : Vec2{0, 20})), 1e-9);
}

TEST(WireSolver, OfHandlesAtOnePlaceTheLastCounts) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  auto handles = three_handles(mesh);
  auto again = handles[1];
  again.target += {7, 7};
  handles.push_back(again);
  // The same corner of two triangles.
  int const corner = mesh.rest.triangles[60][0];
  handles.push_back({{60, {1, 0, 0}}, {0, 0}});
  for (int t = 0; t < 60; ++t) {
    auto const& corners = mesh.rest.triangles[t];
    for (int k = 0; k < 3; ++k) {
      if (corners[k] != corner) continue;
      BendHandle other = {{t, {0, 0, 0}}, {5, 5}};
      other.anchor.weights[k] = 1;
      handles.push_back(other);
    }
  }
  ASSERT_GT(handles.size(), 5U);
  auto pose = mesh.rest.points;
  solver.step(pose, {handles, {}}, 5);
  EXPECT_LT(distance(at(again.anchor, mesh, pose), again.target), 1e-8);
  EXPECT_LT(distance(pose[corner], {5, 5}), 1e-8);
}

TEST(WireSolver, BearsAnythingThatIsALine) {
  std::vector<Contour> const contours = {{{0, 0}, {100, 0}, {0, 0.001}},
                                         {{0, 0}, {50, 0}, {100, 0}, {50, 0}},
                                         {{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}},
                                         {{5, 5}, {5, 5}, {5, 5}},
                                         {{0, 0}, {1e-9, 0}, {0, 1e-9}},
                                         {{-1e6, 0}, {1e6, 0}, {0, 1e6}}};
  for (auto const& contour : contours) {
    auto const mesh = wire_strip(std::span(&contour, 1), 0);
    WireSolver solver(mesh);
    auto pose = mesh.rest.points;
    std::vector<BendHandle> handles;
    for (int t = 0; t < std::ssize(mesh.rest.triangles); ++t)
      handles.push_back({{t, {1, 0, 0}}, {1e6 * (t % 3 - 1), 10.0 * t}});
    handles.front().turn_rad = 2;
    for (std::size_t count = 1; count <= handles.size(); ++count) {
      auto const progress = solver.step(pose, {std::span(handles).first(count), {}}, 10);
      EXPECT_TRUE(std::isfinite(progress.energy));
      for (auto const p : pose) EXPECT_TRUE(is_finite(p));
    }
  }
}

/// Points on a coarse lattice: many coincide, lines turn back on themselves.
std::vector<Contour> random_contours(Rng& rng) {
  std::vector<Contour> contours(static_cast<std::size_t>(1 + rng.below(3)));
  for (auto& contour : contours) {
    int const count = 2 + rng.below(12);
    for (int i = 0; i < count; ++i) contour.push_back({20.0 * rng.below(6), 20.0 * rng.below(6)});
  }
  return contours;
}

BendHandle random_handle(BendMesh const& mesh, Rng& rng) {
  double const a = rng.uniform(-0.2, 1);
  double const b = rng.uniform(0, 1 - a);
  BendHandle handle = {
      {rng.below(static_cast<int>(std::ssize(mesh.rest.triangles))), {a, b, 1 - a - b}},
      {rng.uniform(-300, 400), rng.uniform(-300, 400)}};
  if (rng.below(4) == 0) handle.turn_rad = rng.uniform(-4, 4);
  return handle;
}

TEST(WireSolver, BearsAnyLineHeldAnyhowAndMeetsTheLastHandle) {
  Rng rng(7);
  for (int round = 0; round < 300; ++round) {
    auto const mesh = wire_strip(random_contours(rng), rng.uniform(0, 30));
    WireSolver solver(mesh);
    auto pose = mesh.rest.points;
    std::vector<BendHandle> handles;
    for (int i = 0; i < 8; ++i) {
      handles.push_back(random_handle(mesh, rng));
      std::vector<char> is_fixed(pose.size(), 0);
      for (auto& fixed : is_fixed) fixed = round % 2 == 1 && rng.below(5) == 0 ? 1 : 0;
      auto const progress = solver.step(pose, {handles, is_fixed}, 3);
      EXPECT_TRUE(std::isfinite(progress.energy));
      for (auto const p : pose) ASSERT_TRUE(is_finite(p));
      auto const& last = handles.back();
      if (round % 2 == 0) {
        EXPECT_LT(distance(at(last.anchor, mesh, pose), last.target), 1e-6);
      }
    }
  }
}

TEST(WireSolver, AllPointsAtOnePlaceComeApartAgain) {
  auto const mesh = strip();
  WireSolver solver(mesh);
  BendPose pose(mesh.rest.points.size());
  solver.step(pose, {three_handles(mesh), {}}, 200);
  EXPECT_LT(solver.energy(pose), 1e5);
  EXPECT_GT(distance(pose[0], pose[20]), 100);
}

}  // namespace
}  // namespace inkflate
