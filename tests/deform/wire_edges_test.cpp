// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/wire_strips.h"

namespace inkflate {
namespace {

BendMesh mesh_of(std::vector<Vec2> points, std::vector<Triangle> triangles) {
  BendMesh mesh;
  mesh.rest = {std::move(points), std::move(triangles)};
  mesh.stiffness.assign(mesh.rest.triangles.size(), 1);
  return mesh;
}

TEST(WireEdges, WeighHalfTheCotangentsOfTheAnglesOpposite) {
  double const height = std::sqrt(3) / 2;
  auto const edges =
      wire_edges(mesh_of({{0, 0}, {1, 0}, {0.5, height}, {0.5, -height}}, {{0, 1, 2}, {1, 0, 3}}));
  ASSERT_EQ(std::ssize(edges), 5);
  double const cotangent = 1 / std::sqrt(3);
  EXPECT_NEAR(edges[0].weight, cotangent, 1e-12);  // between two triangles
  for (int i = 1; i < 5; ++i) EXPECT_NEAR(edges[i].weight, cotangent / 2, 1e-12);
  EXPECT_EQ(edges[0].rest, (Vec2{-1, 0}));
}

TEST(WireEdges, WeighAsMuchMoreAsTheirTrianglesAreStiff) {
  auto mesh = support::bean_strip();
  auto const soft = wire_edges(mesh);
  for (auto& stiffness : mesh.stiffness) stiffness = 3;
  auto const stiff = wire_edges(mesh);
  for (std::size_t i = 0; i < soft.size(); ++i)
    EXPECT_NEAR(stiff[i].weight, 3 * soft[i].weight, 1e-12);
}

TEST(WireEdges, HavePositiveWeightsWhateverTheTriangles) {
  auto const mesh = mesh_of({{0, 0}, {10, 0}, {5, 0.1}, {5, 0}, {5, 0}},
                            {{0, 1, 2}, {0, 1, 3}, {0, 3, 4}, {2, 3, 4}});
  for (auto const& edge : wire_edges(mesh)) {
    EXPECT_GT(edge.weight, 0);
    EXPECT_LE(edge.weight, 200);
  }
}

}  // namespace
}  // namespace inkflate
