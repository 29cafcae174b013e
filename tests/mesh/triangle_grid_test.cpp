// SPDX-License-Identifier: Apache-2.0
#include "mesh/triangle_grid.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "support/flat_meshes.h"

namespace inkflate {
namespace {

Vec2 position_of(FlatMesh const& mesh, MeshPlace const& place) {
  Vec2 p;
  for (int k = 0; k < 3; ++k) {
    p += mesh.points[mesh.triangles[place.triangle][k]] * place.shares[k];
  }
  return p;
}

TEST(TriangleGrid, FindsPointsOfARingAndNoneInItsHole) {
  auto const mesh = support::annulus_layer({10, -20}, 30, 80, 5, 40).mesh;
  TriangleGrid const grid(mesh);
  Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    Vec2 const p = {rng.uniform(-100, 120), rng.uniform(-130, 90)};
    double const radius = distance(p, {10, -20});
    auto const place = grid.find(p);
    // The rims are polygons of 40 corners, up to 0.3 % inside of their circles.
    if (radius < 29.9 || radius > 80) {
      EXPECT_FALSE(place) << p.x << " " << p.y;
    } else if (radius > 30 && radius < 79.7) {
      ASSERT_TRUE(place) << p.x << " " << p.y;
      EXPECT_LT(distance(position_of(mesh, *place), p), 1e-9);
    }
  }
}

TEST(TriangleGrid, FindsEveryVertexAndEveryMiddleOfAnEdge) {
  auto const mesh = support::disc_layer({0, 0}, 50, 6).mesh;
  TriangleGrid const grid(mesh);
  for (auto const& t : mesh.triangles) {
    EXPECT_TRUE(grid.find(mesh.points[t[0]]));
    EXPECT_TRUE(grid.find((mesh.points[t[0]] + mesh.points[t[1]]) / 2));
  }
}

TEST(TriangleGrid, InterpolatesPlanesExactly) {
  auto const mesh = support::disc_layer({0, 0}, 50, 6).mesh;
  TriangleGrid const grid(mesh);
  std::vector<double> values;
  for (auto const p : mesh.points) values.push_back(3 + 2 * p.x - p.y);
  EXPECT_NEAR(interpolate(mesh, values, *grid.find({12, -7})), 34, 1e-12);
}

TEST(TriangleGrid, OfNoTrianglesFindsNothing) {
  FlatMesh const empty;
  EXPECT_FALSE(TriangleGrid(empty).find({0, 0}));
}

}  // namespace
}  // namespace inkflate
