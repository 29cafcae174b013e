// SPDX-License-Identifier: Apache-2.0
#include "deform/grip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "deform/body_solver.h"
#include "support/bend_meshes.h"

namespace inkflate {
namespace {

// A bar of 200 x 40 px in squares of 10 px, and the middle of its upper side.
BendMesh bar() { return support::bar_mesh(200, 40, 20, 4); }

BendHandle at_vertex(BendMesh const& mesh, Vec2 place, double grip_px) {
  return {support::anchor_near(mesh, place), place, {}, grip_px};
}

double farthest_stiffened_px(BendMesh const& mesh, Grips const& grips, Vec2 centre) {
  double farthest = 0;
  for (std::size_t t = 0; t < mesh.rest.triangles.size(); ++t) {
    if (grips.factors()[t] == 1) continue;
    for (int const v : mesh.rest.triangles[t]) {
      farthest = std::max(farthest, distance(mesh.rest.points[v], centre));
    }
  }
  return farthest;
}

TEST(Grips, AreStiffAtTheHandleAndNothingBeyondTheirRadius) {
  auto const mesh = bar();
  Grips grips(mesh);
  auto const handle = at_vertex(mesh, {100, -20}, 30);
  EXPECT_TRUE(grips.update({&handle, 1}));
  auto const& factors = grips.factors();
  EXPECT_GT(factors[handle.anchor.triangle], Grips::kStiffest / 2);
  EXPECT_LE(*std::max_element(factors.begin(), factors.end()), Grips::kStiffest);
  EXPECT_EQ(*std::min_element(factors.begin(), factors.end()), 1);
  double const farthest = farthest_stiffened_px(mesh, grips, {100, -20});
  EXPECT_GT(farthest, 20);
  EXPECT_LT(farthest, 30 + 10);  // a triangle whose middle lies within
}

TEST(Grips, FallToNothingWithoutAStep) {
  auto const mesh = bar();
  Grips grips(mesh);
  auto const handle = at_vertex(mesh, {100, -20}, 50);
  ASSERT_TRUE(grips.update({&handle, 1}));
  for (std::size_t t = 0; t < mesh.rest.triangles.size(); ++t) {
    auto const& [a, b, c] = mesh.rest.triangles[t];
    auto const& p = mesh.rest.points;
    double const share = distance((p[a] + p[b] + p[c]) / 3, {100, -20}) / 50;
    double const left = std::max(0.0, 1 - share * share);
    EXPECT_NEAR(grips.factors()[t], 1 + (Grips::kStiffest - 1) * left * left, 1e-9) << share;
  }
}

TEST(Grips, OfHandlesThatAreGoneLeaveNothing) {
  auto const mesh = bar();
  Grips grips(mesh);
  auto const handle = at_vertex(mesh, {100, -20}, 30);
  EXPECT_TRUE(grips.update({&handle, 1}));
  EXPECT_FALSE(grips.update({&handle, 1}));
  EXPECT_TRUE(grips.update({}));
  EXPECT_EQ(grips.factors(), std::vector<double>(mesh.rest.triangles.size(), 1.0));
}

TEST(Grips, DoNotReachAcrossAGap) {
  auto const upper = bar();
  auto lower = upper;
  for (auto& p : lower.rest.points) p.y += 45;
  auto const mesh = support::side_by_side(upper, lower);
  Grips grips(mesh);
  auto const handle = at_vertex(mesh, {100, 20}, 40);
  grips.update({&handle, 1});
  for (std::size_t t = upper.rest.triangles.size(); t < mesh.rest.triangles.size(); ++t) {
    EXPECT_EQ(grips.factors()[t], 1);
  }
}

/// How sharply the upper side of the bar bends at its middle when that is pulled up by 20 px, in radians.
double spike_rad(double grip_px) {
  auto const mesh = bar();
  BodySolver solver(mesh);
  auto pose = mesh.rest.points;
  std::vector<BendHandle> const handles = {at_vertex(mesh, {0, 20}, 0),
                                           at_vertex(mesh, {200, 20}, 0),
                                           at_vertex(mesh, {100, -20}, grip_px)};
  auto pulled = handles;
  pulled.back().target += Vec2{0, -20};
  solver.step(pose, {pulled, {}}, 40);
  auto const place = [&](double x) {
    return place_of(mesh.rest, pose, at_vertex(mesh, {x, -20}, 0).anchor);
  };
  Vec2 const before = normalized(place(100) - place(90));
  Vec2 const after = normalized(place(110) - place(100));
  return std::abs(cross(before, after));
}

TEST(Grips, MakeABumpOfASpike) { EXPECT_LT(3 * spike_rad(30), spike_rad(0)); }

}  // namespace
}  // namespace inkflate
