// SPDX-License-Identifier: Apache-2.0
#include "render/layer_rims.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/render_models.h"

namespace inkflate {
namespace {

TEST(LayerRims, TheRimOfABallIsOneClosedLine) {
  auto model = empty_model(400, 400);
  add_ball(model, {{200, 200}, 100, 0, 6, 24});
  add_ball(model, {{220, 200}, 50, 90, 4, 12});
  auto const rims = layer_rims(model);
  ASSERT_EQ(rims.size(), 2U);
  ASSERT_EQ(rims[0].size(), 1U);
  ASSERT_EQ(rims[1].size(), 1U);
  EXPECT_EQ(rims[0][0].points.size(), 25U);
  EXPECT_EQ(rims[0][0].points.front(), rims[0][0].points.back());
  for (auto const point : rims[0][0].points) EXPECT_NEAR(distance(point, {200, 200}), 100, 1e-9);
  for (auto const point : rims[1][0].points) EXPECT_NEAR(distance(point, {220, 200}), 50, 1e-9);
}

TEST(LayerRims, AnOpenRunEndsTheLine) {
  auto model = empty_model(400, 400);
  add_ball(model, {{200, 200}, 100, 0, 6, 24});
  // Without the outermost triangles between sectors 0 and 3 the sheets do not meet there.
  auto const is_kept = [&](std::size_t t) {
    int on_rim = 0;
    for (int const corner : model.mesh.triangles[t]) on_rim += corner <= 3 ? 1 : 0;
    return on_rim < 2;
  };
  RestModel open = model;
  open.mesh.triangles.clear();
  open.faces.clear();
  for (std::size_t t = 0; t < model.faces.size(); ++t) {
    if (!is_kept(t)) continue;
    open.mesh.triangles.push_back(model.mesh.triangles[t]);
    open.faces.push_back(model.faces[t]);
  }
  auto const rims = layer_rims(open);
  ASSERT_EQ(rims.size(), 1U);
  ASSERT_EQ(rims[0].size(), 1U);
  EXPECT_EQ(rims[0][0].points.size(), 22U);
  EXPECT_NEAR(distance(rims[0][0].points.front(), model.canvas[3]), 0, 1e-9);
  EXPECT_NEAR(distance(rims[0][0].points.back(), model.canvas[0]), 0, 1e-9);
}

TEST(LayerRims, ACapIsNoPartOfIt) {
  // A box seen from the front whose right side is a cap between front (0 .. 3) and back (4 .. 7).
  RestModel box = empty_model(10, 10);
  for (double const z : {1.0, -1.0}) {
    for (Vec2 const place : std::vector<Vec2>{{2, 2}, {2, 8}, {8, 8}, {8, 2}}) {
      box.mesh.points.push_back({place.x - 5, 5 - place.y, z});
      box.canvas.push_back(place);
    }
  }
  box.mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {3, 2, 6}, {3, 6, 7}};
  box.faces = {{0, Side::Front}, {0, Side::Front}, {0, Side::Back},
               {0, Side::Back},  {0, Side::Back},  {0, Side::Front}};
  EXPECT_TRUE(layer_rims(box)[0].empty());
}

TEST(LayerRims, SteepnessIsThatOfTheOutermostTriangles) {
  auto model = empty_model(400, 400);
  add_ball(model, {{200, 200}, 100, 0, 6, 360});
  // The outermost ring of the ball spans 15 degrees.
  auto const turn = sin_cos(kPi / 12);
  double const expected =
      std::sqrt(turn.sin * turn.sin + (1 - turn.cos) * (1 - turn.cos)) / (1 - turn.cos);
  auto const rims = layer_rims(model);
  for (double const steepness : rims[0][0].steepness) {
    EXPECT_NEAR(steepness, expected, 0.01 * expected);
  }
}

TEST(LayerRims, WithoutTrianglesThereIsNone) { EXPECT_TRUE(layer_rims({}).empty()); }

}  // namespace
}  // namespace inkflate
