// SPDX-License-Identifier: Apache-2.0
#include "mesh/connected_vertices.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

TEST(ConnectedVertices, NamesEachPieceByItsLowestVertex) {
  FlatMesh const mesh = {std::vector<Vec2>(7), {{4, 5, 6}, {0, 1, 3}}};
  EXPECT_EQ(connected_vertices(mesh), (std::vector<int>{0, 0, 2, 0, 4, 4, 4}));
}

TEST(ConnectedVertices, JoinsPiecesThatShareASingleVertexInWhateverOrderTheyCome) {
  FlatMesh const mesh = {std::vector<Vec2>(7), {{6, 5, 4}, {3, 2, 1}, {4, 0, 3}}};
  EXPECT_EQ(connected_vertices(mesh), std::vector<int>(7, 0));
}

TEST(ConnectedVertices, OfAnEmptyMeshAreNone) { EXPECT_TRUE(connected_vertices({}).empty()); }

}  // namespace
}  // namespace inkflate
