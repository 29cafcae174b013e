// SPDX-License-Identifier: Apache-2.0
#include "inflate/layer_heights.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/flat_meshes.h"

namespace inkflate {
namespace {

using support::Ends;

/// The largest error of u = height^2 against R^2 - r^2, as a share of R^2.
double ball_error(int rings) {
  double const radius = 100;
  auto layer = support::disc_layer({50, 80}, radius, rings);
  layer.thickness = 4;
  auto const heights = layer_heights(layer);
  double worst = 0;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    double const truth = radius * radius - squared_norm(layer.mesh.points[i] - Vec2{50, 80});
    worst = std::max(worst, std::abs(heights[i] * heights[i] - truth) / (radius * radius));
  }
  return worst;
}

TEST(LayerHeights, DiscOfThicknessFourIsAHalfBall) {
  EXPECT_LT(ball_error(5), 1e-2);
  EXPECT_LT(ball_error(20), 7e-4);
}

TEST(LayerHeights, ErrorFallsWithTheSquareOfTheSpacing) {
  EXPECT_GT(ball_error(5) / ball_error(10), 3.5);
  EXPECT_GT(ball_error(10) / ball_error(20), 3.5);
}

TEST(LayerHeights, LongTubeIsRound) {
  auto const layer = support::strip_layer({0, 0}, {600, 0}, 60, 200, 20, Ends::None);
  auto const heights = layer_heights(layer);
  for (int j = 0; j <= 20; ++j) {
    double const y = layer.mesh.points[100 * 21 + j].y;
    EXPECT_NEAR(heights[100 * 21 + j], std::sqrt(900 - y * y), 0.01);
  }
}

TEST(LayerHeights, TubeWithOpenEndsIsTheSameAllAlong) {
  auto const layer = support::strip_layer({0, 0}, {100, 0}, 60, 10, 8, Ends::Both);
  auto const heights = layer_heights(layer);
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 8; ++j) EXPECT_NEAR(heights[i * 9 + j], heights[j], 1e-10);
  }
  EXPECT_NEAR(heights[4], 30, 1e-10);  // parabolas are exact on this mesh
}

TEST(LayerHeights, GrowWithTheRootOfTheThickness) {
  auto layer = support::annulus_layer({0, 0}, 30, 80, 6, 40);
  auto const plain = layer_heights(layer);
  layer.thickness *= 9;
  auto const thick = layer_heights(layer);
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_NEAR(thick[i], 3 * plain[i], 1e-9);
}

TEST(LayerHeights, AreZeroOnTheDrawnRimOnly) {
  auto const layer = support::strip_layer({10, 20}, {90, 140}, 25, 12, 5, Ends::First);
  auto const heights = layer_heights(layer);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    EXPECT_EQ(heights[i] > 0, layer.kinds[i] != VertexKind::Drawn) << i;
  }
}

TEST(LayerHeights, ASliverOfAMeshStaysFinite) {
  FlatLayer layer;
  layer.mesh.points = {{0, 0}, {100, 0}, {50, 1e-9}, {50, 40}};
  layer.mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 0, 2}};
  layer.kinds = {VertexKind::Drawn, VertexKind::Drawn, VertexKind::Inside, VertexKind::Drawn};
  double const height = layer_heights(layer)[2];
  EXPECT_TRUE(height > 0 && height < 40) << height;
}

TEST(LayerHeights, WithoutADrawnRimAreFlatButThere) {
  auto layer = support::disc_layer({0, 0}, 50, 3);
  std::fill(layer.kinds.begin(), layer.kinds.end(), VertexKind::Open);
  for (double const h : layer_heights(layer)) EXPECT_TRUE(h > 0 && h < 100) << h;
}

}  // namespace
}  // namespace inkflate
