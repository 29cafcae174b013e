// SPDX-License-Identifier: Apache-2.0
#include "mesh/check_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/rng.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Corners in the order of their bits: x, y, z.
TriMesh cube(Vec3 low = {0, 0, 0}, double size = 1) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(low + Vec3{i & 1 ? size : 0, i & 2 ? size : 0, i & 4 ? size : 0});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A ring with a rectangular cross-section, as a grid of count x 4 vertices.
TriMesh ring(int count) {
  TriMesh mesh;
  Vec3 const profile[] = {{2, 0, 0}, {3, 0, 0}, {3, 0, 1}, {2, 0, 1}};
  for (int i = 0; i < count; ++i) {
    // Any closed polygon around the axis will do.
    double const x = i < count / 2 ? 1.0 - 4.0 * i / count : -3.0 + 4.0 * i / count;
    double const y = i < count / 2 ? 1 - std::abs(x) : std::abs(x) - 1;
    for (auto const p : profile) mesh.points.push_back({p.x * x, p.x * y, p.z});
  }
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 4; ++k) {
      int const a = 4 * i + k;
      int const b = 4 * i + (k + 1) % 4;
      int const c = 4 * ((i + 1) % count) + k;
      int const d = 4 * ((i + 1) % count) + (k + 1) % 4;
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({b, c, d});
    }
  }
  return mesh;
}

void append(TriMesh& mesh, TriMesh const& other) {
  int const first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (auto t : other.triangles) {
    for (int& v : t) v += first;
    mesh.triangles.push_back(t);
  }
}

TEST(CheckMesh, ACubeIsSoundAndItsNumbersAreThoseOfACube) {
  auto const check = check_mesh(cube({-1, 2, 5}, 2));
  EXPECT_TRUE(check.is_sound());
  EXPECT_EQ(check.shells, 1);
  EXPECT_EQ(check.genus, 0);
  EXPECT_EQ(check.euler, 2);
  EXPECT_DOUBLE_EQ(check.volume, 8);
  EXPECT_EQ(check.min, (Vec3{-1, 2, 5}));
  EXPECT_EQ(check.max, (Vec3{1, 4, 7}));
}

TEST(CheckMesh, ARingHasAHandle) {
  auto const check = check_mesh(ring(8));
  EXPECT_TRUE(check.is_sound());
  EXPECT_EQ(check.genus, 1);
  EXPECT_EQ(check.euler, 0);
  // The area between two squares of half diagonal 3 and 2, times the height 1.
  EXPECT_NEAR(check.volume, 2 * 9 - 2 * 4, 1e-12);
}

TEST(CheckMesh, ShellsAreCountedAndTheirHandlesSummedUp) {
  auto mesh = ring(8);
  append(mesh, ring(12));
  append(mesh, cube());
  auto const check = check_mesh(mesh);
  EXPECT_TRUE(check.is_sound());
  EXPECT_EQ(check.shells, 3);
  EXPECT_EQ(check.genus, 2);
}

TEST(CheckMesh, AHoleHasABoundary) {
  auto mesh = cube();
  mesh.triangles.pop_back();
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.boundary_edges, 3);
  EXPECT_FALSE(check.is_closed());
  EXPECT_FALSE(check.is_sound());
  EXPECT_EQ(check.genus, 0);
}

TEST(CheckMesh, ATriangleTurnedRoundDisagreesWithItsNeighbours) {
  auto mesh = ring(8);
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.misoriented_edges, 3);
  EXPECT_FALSE(check.is_oriented());
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, ADoubledTriangleIsNotManifold) {
  auto mesh = cube();
  mesh.triangles.push_back(mesh.triangles[4]);
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.non_manifold_edges, 3);
  EXPECT_FALSE(check.is_manifold());
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, InsideOutIsSeenFromTheVolume) {
  auto mesh = cube({1e5, 0, 0});
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.misoriented_edges, 0);
  EXPECT_TRUE(check.is_inside_out);
  EXPECT_NEAR(check.volume, -1, 1e-12);
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, TwoFansAtOneVertexAreNotManifold) {
  auto mesh = cube();
  append(mesh, cube({1, 1, 1}));
  mesh = weld_vertices(mesh);
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.non_manifold_vertices, 1);
  EXPECT_EQ(check.non_manifold_edges, 0);
  EXPECT_EQ(check.shells, 2);
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, TwoCubesThatShareAnEdgeAreNotManifold) {
  auto mesh = cube();
  append(mesh, cube({1, 1, 0}));
  auto const check = check_mesh(weld_vertices(mesh));
  EXPECT_EQ(check.non_manifold_edges, 1);
  EXPECT_TRUE(check.is_closed());
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, ATriangleOnALineHasNoArea) {
  auto mesh = cube();
  // The top's diagonal gets a vertex that only one of its two triangles has an area to.
  mesh.points.push_back({0.5, 0.5, 0});
  mesh.triangles[1] = {1, 2, 8};
  mesh.triangles.push_back({8, 2, 3});
  mesh.triangles.push_back({1, 8, 3});
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.zero_area_triangles, 1);
  EXPECT_TRUE(check.is_closed());
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, ATriangleFoldedOntoItsNeighboursIsFlipped) {
  // A grid of 3 x 3 vertices whose middle one is pulled over its neighbour would fold two triangles; a vertex of valence three that is
  // pulled out of its triangle folds one.
  TriMesh mesh = cube();
  mesh.points.push_back({0.4, 0.4, 0});
  mesh.triangles[0] = {0, 2, 8};
  mesh.triangles.push_back({2, 1, 8});
  mesh.triangles.push_back({1, 0, 8});
  ASSERT_TRUE(check_mesh(mesh).is_sound());
  mesh.points[8] = {0.9, 0.9, 0};
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.misoriented_edges, 0);
  EXPECT_EQ(check.flipped_triangles, 1);
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, WhatIsNotFiniteIsCounted) {
  auto mesh = cube();
  mesh.points[3].y = kNan;
  mesh.points[5].z = std::numeric_limits<double>::infinity();
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.non_finite_points, 2);
  EXPECT_EQ(check.zero_area_triangles, 0);
  EXPECT_EQ(check.max, (Vec3{1, 1, 1}));
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, BadIndicesAreCounted) {
  auto mesh = cube();
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({0, -1, 2});
  mesh.triangles.push_back({4, 4, 5});
  auto const check = check_mesh(mesh);
  EXPECT_EQ(check.bad_indices, 3);
  EXPECT_TRUE(check.is_closed());
  EXPECT_FALSE(check.is_sound());
}

TEST(CheckMesh, NothingIsSound) {
  auto const check = check_mesh({});
  EXPECT_TRUE(check.is_sound());
  EXPECT_EQ(check.shells, 0);
  EXPECT_EQ(check.min, (Vec3{}));
}

TEST(CheckMesh, GarbageIsLookedAtWithoutHarm) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng(seed);
    TriMesh mesh;
    double const special[] = {kNan,  0,      -0.0,   1,
                              1e308, -1e308, 1e-308, std::numeric_limits<double>::infinity()};
    for (int i = rng.below(12); i > 0; --i)
      mesh.points.push_back({special[rng.below(8)], special[rng.below(8)], rng.uniform(-1, 1)});
    for (int i = rng.below(40); i > 0; --i)
      mesh.triangles.push_back({rng.below(14) - 1, rng.below(14) - 1, rng.below(14) - 1});
    auto const check = check_mesh(mesh);
    EXPECT_LE(check.bad_indices, std::ssize(mesh.triangles));
    EXPECT_EQ(check_mesh(weld_vertices(mesh)).is_sound() && check.is_sound(), check.is_sound());
    EXPECT_LE(count_self_crossings(mesh, 5), 5);
  }
}

TEST(WeldVertices, MakesOneOfEqualPointsAndLeavesOutTheUnused) {
  auto const whole = cube();
  TriMesh loose;
  loose.points.push_back({9, 9, 9});
  for (auto const& t : whole.triangles) {
    int const first = static_cast<int>(loose.points.size());
    for (int const v : t) loose.points.push_back(whole.points[v]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(check_mesh(loose).boundary_edges, 36);
  auto const welded = weld_vertices(loose);
  EXPECT_EQ(welded.points.size(), 8U);
  EXPECT_TRUE(check_mesh(welded).is_sound());
}

TEST(WeldVertices, MinusZeroIsZero) {
  TriMesh const mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}}, {{0, 1, 2}, {3, 2, 1}}};
  EXPECT_EQ(weld_vertices(mesh).points.size(), 3U);
}

TEST(WeldVertices, BadIndicesStayBad) {
  TriMesh const mesh = {{{0, 0, 0}}, {{0, 7, -3}}};
  EXPECT_EQ(check_mesh(weld_vertices(mesh)).bad_indices, 1);
}

TEST(SelfCrossings, ASoundMeshHasNone) { EXPECT_EQ(count_self_crossings(ring(40)), 0); }

TEST(SelfCrossings, TwoTrianglesThatPassThroughEachOtherAreOnePair) {
  TriMesh const mesh = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {2, 1.5, 1}},
                        {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(count_self_crossings(mesh), 1);
}

TEST(SelfCrossings, CubesThatOverlapCross) {
  auto mesh = cube();
  append(mesh, cube({0.3, 0.4, 0.55}));
  EXPECT_TRUE(check_mesh(mesh).is_sound());
  EXPECT_GT(count_self_crossings(mesh), 5);
  EXPECT_EQ(count_self_crossings(mesh, 3), 3);
}

TEST(SelfCrossings, ATouchIsNotACrossing) {
  auto mesh = cube();
  append(mesh, cube({1, 0, 0}));
  append(mesh, cube({0.25, 0.25, 1}, 0.5));
  EXPECT_EQ(count_self_crossings(mesh), 0);
}

TEST(SelfCrossings, AsManyAsAllPairsSay) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    TriMesh mesh;
    int const count = 60;
    for (int t = 0; t < count; ++t) {
      // A few large ones among small ones.
      double const size = t % 10 == 0 ? 8 : 1;
      Vec3 const at = {rng.uniform(0, 4), rng.uniform(0, 4), rng.uniform(0, 4)};
      for (int i = 0; i < 3; ++i)
        mesh.points.push_back(
            at + Vec3{rng.uniform(0, size), rng.uniform(0, size), rng.uniform(0, size)});
      mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    int one_by_one = 0;
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < a; ++b)
        one_by_one += count_self_crossings({mesh.points, {mesh.triangles[a], mesh.triangles[b]}});
    }
    EXPECT_GT(one_by_one, 0);
    EXPECT_EQ(count_self_crossings(mesh), one_by_one);
  }
}

}  // namespace
}  // namespace inkflate
