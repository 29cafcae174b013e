// SPDX-License-Identifier: Apache-2.0
#include "mesh/triangles_at.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

std::vector<int> at(FlatMesh const& mesh, int vertex) {
  TrianglesAt const triangles(mesh);
  auto const found = triangles[vertex];
  return {found.begin(), found.end()};
}

TEST(TrianglesAt, AreAllThatHaveTheVertexAscending) {
  FlatMesh const mesh = {std::vector<Vec2>(5), {{2, 0, 1}, {1, 3, 2}, {3, 1, 0}}};
  EXPECT_EQ(at(mesh, 0), (std::vector<int>{0, 2}));
  EXPECT_EQ(at(mesh, 1), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(at(mesh, 2), (std::vector<int>{0, 1}));
  EXPECT_EQ(at(mesh, 3), (std::vector<int>{1, 2}));
  EXPECT_TRUE(at(mesh, 4).empty());
}

}  // namespace
}  // namespace inkflate
