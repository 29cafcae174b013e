// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rng.h"
#include "deform/wire_strip.h"
#include "support/wire_strips.h"

namespace inkflate {
namespace {

using namespace support;

TEST(WireSolver, EnergyNeverRisesOnceTheHandlesAreMet) {
  auto const mesh = bean_strip();
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

TEST(WireSolver, HandlesThatMoveRigidlyCarryAllWithThem) {
  auto const mesh = bean_strip();
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
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 5, {30, 40})};
  solver.step(pose, {handles, {}}, 5);
  for (std::size_t v = 0; v < pose.size(); ++v)
    EXPECT_LT(distance(pose[v], mesh.rest.points[v] + Vec2{30, 40}), 1e-9);
}

TEST(WireSolver, NothingMovesWithoutHandles) {
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  auto bent = mesh.rest.points;
  solver.step(bent, {three_handles(mesh), {}}, 5);
  auto pose = bent;
  EXPECT_TRUE(solver.step(pose, {}, 5).is_settled);
  EXPECT_EQ(pose, bent);
}

TEST(WireSolver, HandlesAtTheirRestLeaveTheRestPose) {
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {moved(mesh, 5, {}), moved(mesh, 50, {})};
  EXPECT_TRUE(solver.step(pose, {handles, {}}, 5).is_settled);
  EXPECT_LT(largest_distance(pose, mesh.rest.points), 1e-10);
}

TEST(WireSolver, TheSameTwiceGivesTheSameBits) {
  auto const mesh = bean_strip();
  auto const handles = three_handles(mesh);
  BendPose poses[2] = {mesh.rest.points, mesh.rest.points};
  for (auto& pose : poses) {
    WireSolver solver(mesh);
    solver.step(pose, {handles, {}}, 30);
  }
  EXPECT_EQ(poses[0], poses[1]);
}

TEST(WireSolver, AMirroredMeshBendsAsItsMirrorImage) {
  auto const mesh = bean_strip();
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

TEST(WireSolver, ATurnedHandleTurnsItsTriangle) {
  auto const mesh = bean_strip();
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
  auto const mesh = bean_strip();
  WireSolver solver(mesh);
  BendPose pose(mesh.rest.points.size());
  solver.step(pose, {three_handles(mesh), {}}, 200);
  EXPECT_LT(solver.energy(pose), 1e5);
  EXPECT_GT(distance(pose[0], pose[20]), 100);
}

}  // namespace
}  // namespace inkflate
