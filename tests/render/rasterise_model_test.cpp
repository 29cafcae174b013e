// SPDX-License-Identifier: Apache-2.0
#include "render/rasterise_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/hash.h"
#include "render/bake_texture.h"
#include "render/sample_band.h"
#include "render/surface_normal.h"
#include "support/render_models.h"

namespace inkflate {
namespace {

constexpr Colour kRed = {255, 0, 0};
constexpr Colour kBlue = {0, 0, 255};

RestModel one_ball(int rings = 64, int sectors = 192) {
  auto model = empty_model(400, 400);
  add_ball(model, {{200, 200}, 100, 0, rings, sectors});
  return model;
}

/// A ball in front of a larger one, both around the middle of the canvas.
RestModel two_balls() {
  auto model = empty_model(400, 400);
  add_ball(model, {{200, 200}, 100, 0, 24, 72});
  add_ball(model, {{200, 200}, 40, 150, 16, 48});
  return model;
}

/// Front view, so that one px of the model is one px of the picture.
DrawTriangles unscaled(RestModel const& model) {
  DrawTriangles list;
  list.positions = model.mesh.points;
  list.normals = model.normals;
  list.triangles = model.mesh.triangles;
  return list;
}

double opaque_area(Picture const& picture) {
  double sum = 0;
  for (auto const pixel : picture.values) sum += pixel.a / 255.0;
  return sum;
}

TEST(SampleBand, ABallHasTheDepthsAndNormalsOfASphere) {
  auto const list = unscaled(one_ball());
  SampleGrid const grid(list, 240, 240);
  SampleBand band(grid.width(), grid.height());
  band.start(0);
  for (int t = 0; t < std::ssize(list.triangles); ++t) band.add(grid, t);
  int inside = 0;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      Vec2 const p = {(x + 0.5) / 3 - 120, 120 - (y + 0.5) / 3};
      int const triangle = band.triangles().at(x, y);
      if (norm(p) > 100.01) {
        ASSERT_EQ(triangle, -1);
      }
      if (norm(p) > 97) continue;
      double const z = std::sqrt(10000 - squared_norm(p));
      ASSERT_GE(triangle, 0);
      ASSERT_NEAR(static_cast<double>(band.depths().at(x, y)), z, 0.3);
      auto const normal = surface_normal(list, grid, triangle, x + 0.5, y + 0.5);
      ASSERT_LT(distance(normal, Vec3{p.x, p.y, z} / 100), 0.01);
      ++inside;
    }
  }
  EXPECT_GT(inside, 250'000);
}

TEST(SampleBand, TrianglesThatShareAnEdgeLeaveNoSampleBetweenThem) {
  // A fan around a point that is no sample, with corners at odd places.
  DrawTriangles list;
  list.positions.push_back({0.123, 0.377, 0});
  for (int i = 0; i < 37; ++i) {
    auto const turn = sin_cos(2 * kPi * i / 37);
    list.positions.push_back({30 * turn.cos, 30 * turn.sin, 0});
  }
  for (int i = 0; i < 37; ++i) list.triangles.push_back({0, 1 + i, 1 + (i + 1) % 37});
  SampleGrid const grid(list, 40, 40);
  SampleBand band(grid.width(), grid.height());
  band.start(0);
  for (int t = 0; t < 37; ++t) band.add(grid, t);
  for (auto const triangle : band.triangles().values) ASSERT_GE(triangle, 0);
}

TEST(RasteriseModel, TheSilhouetteOfABallIsADisc) {
  auto const picture = rasterise_model(unscaled(one_ball()), 240, 240);
  EXPECT_NEAR(opaque_area(picture), kPi * 10000, 0.002 * kPi * 10000);
}

TEST(RasteriseModel, ATurnedBallKeepsItsSilhouette) {
  auto const model = one_ball();
  auto const front = opaque_area(
      rasterise_model(draw_model(model, nullptr, {}, Shading::Matcap, 200, 200), 200, 200));
  ModelView const view = {1.1, -0.4, 1, {}};
  auto const turned = opaque_area(
      rasterise_model(draw_model(model, nullptr, view, Shading::Matcap, 200, 200), 200, 200));
  EXPECT_NEAR(turned, front, 0.003 * front);
}

TEST(DrawModel, TheModelFillsThePictureButForAMargin) {
  for (double const turn_rad : {0.0, 0.7, 2.0}) {
    auto const list =
        draw_model(two_balls(), nullptr, {turn_rad, 0.3, 1, {}}, Shading::Matcap, 300, 200);
    Rect box;
    for (auto const p : list.positions) box.include({p.x, p.y});
    EXPECT_NEAR(std::max(box.width() / 300, box.height() / 200), 0.88, 1e-9);
    EXPECT_NEAR(norm(box.centre()), 0, 1e-9);
  }
}

TEST(DrawModel, TurningIsWalkingToTheRightAndTiltingIsRising) {
  auto const at_small_ball = [](ModelView const& view) {
    return draw_model(two_balls(), nullptr, view, Shading::Matcap, 200, 200).positions.back();
  };
  // The small ball is nearer to the viewer: it moves against the way that the viewer goes.
  EXPECT_LT(at_small_ball({0.5, 0, 1, {}}).x, -10);
  EXPECT_LT(at_small_ball({0, 0.5, 1, {}}).y, -10);
  EXPECT_GT(at_small_ball({0, 0, 1, {7, 0}}).x, 6);
}

TEST(RasteriseModel, WhatIsNearerHidesWhatIsBehindIt) {
  auto const model = two_balls();
  Texture texture;
  texture.picture = Picture(2, 1, kRed);
  texture.picture.at(1, 0) = kBlue;
  for (auto const& face : model.faces) {
    Vec2 const place = {face.layer == 0 ? 0.0 : 1.0, 0};
    texture.corners.push_back({place, place, place});
  }
  auto const middle = [&](double turn_rad) {
    auto const list = draw_model(model, &texture, {turn_rad, 0, 1, {}}, Shading::Textured, 99, 99);
    return rasterise_model(list, 99, 99).at(49, 49);
  };
  EXPECT_GT(middle(0).b, 200);
  EXPECT_LT(middle(0).r, 40);
  EXPECT_GT(middle(kPi).r, 150);
  EXPECT_LT(middle(kPi).b, 40);
}

TEST(RasteriseModel, TheTextureIsTheRightWayUpOnBothSides) {
  // Red above blue; white on the left half of the canvas' upper part.
  Picture canvas(4, 4, kBlue);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) canvas.at(x, y) = x < 2 ? Colour{255, 255, 255} : kRed;
  }
  auto const model = one_ball(16, 48);
  auto const texture = wear_picture(canvas, model);
  auto const front =
      rasterise_model(draw_model(model, &texture, {}, Shading::Textured, 100, 100), 100, 100);
  EXPECT_GT(front.at(30, 30).g, 150);
  EXPECT_LT(front.at(70, 30).g, 60);
  EXPECT_GT(front.at(70, 30).r, 150);
  EXPECT_GT(front.at(30, 70).b, front.at(30, 70).r + 100);
  auto const back = rasterise_model(
      draw_model(model, &texture, {kPi, 0, 1, {}}, Shading::Textured, 100, 100), 100, 100);
  EXPECT_LT(back.at(30, 30).g, 60);
  EXPECT_GT(back.at(70, 30).g, 150);
  EXPECT_GT(back.at(70, 70).b, back.at(70, 70).r + 100);
}

TEST(RasteriseModel, LinesInkTheSilhouetteAndWhereOnePartIsBeforeAnother) {
  auto const list = draw_model(two_balls(), nullptr, {}, Shading::Lines, 400, 400);
  auto const picture = rasterise_model(list, 400, 400);
  // Where the row through the middle turns dark: both borders of both balls.
  int dark = 0;
  for (int x = 1; x < 400; ++x) {
    auto const is_dark = [&](int column) {
      auto const pixel = picture.at(column, 200);
      return pixel.a > 100 && pixel.r < 128;
    };
    if (is_dark(x) && !is_dark(x - 1)) ++dark;
  }
  EXPECT_EQ(dark, 4);
}

TEST(RasteriseModel, TheBackgroundStaysWhereNothingIs) {
  ModelPictureOptions options;
  options.background = {10, 20, 30};
  auto const picture = rasterise_model(unscaled(one_ball(8, 24)), 240, 240, options);
  EXPECT_EQ(picture.at(2, 2), (Colour{10, 20, 30}));
  EXPECT_EQ(rasterise_model({}, 2, 2).at(1, 1), (Colour{0, 0, 0, 0}));
}

TEST(RasteriseModel, BandsDoNotShow) {
  // The same place of the model, moved by rows: no row of the picture depends on where its band begins.
  auto const model = two_balls();
  for (auto const shading : {Shading::Matcap, Shading::Lines}) {
    auto const still = rasterise_model(draw_model(model, nullptr, {}, shading, 128, 128), 128, 128);
    auto const moved =
        rasterise_model(draw_model(model, nullptr, {0, 0, 1, {0, 5}}, shading, 128, 128), 128, 128);
    for (int y = 0; y < 123; ++y) {
      for (int x = 0; x < 128; ++x) ASSERT_EQ(still.at(x, y), moved.at(x, y + 5)) << x << ' ' << y;
    }
  }
}

TEST(RasteriseModel, PicturesAreTheSameBytesEverywhere) {
  auto const model = two_balls();
  Drawing drawing;
  add_disc(drawing, {200, 200}, 100, {80, 20, 10}).fill = Colour{255, 200, 120};
  add_disc(drawing, {200, 200}, 40).fill = Colour{150, 210, 255};
  add_detail(drawing, 0, {120, 170}, {260, 230}, {0, 90, 0});
  auto const texture = bake_texture(drawing, model);
  Hash hash;
  for (auto const shading : {Shading::Matcap, Shading::Textured, Shading::Lines}) {
    auto const list = draw_model(model, &texture, {0.5, 0.2, 1, {}}, shading, 96, 80);
    for (auto const pixel : rasterise_model(list, 96, 80).values) {
      for (int const channel : {pixel.r, pixel.g, pixel.b, pixel.a}) {
        hash.add(static_cast<std::int64_t>(channel));
      }
    }
  }
  EXPECT_EQ(hash.value(), 6412331627426361216U);
}

}  // namespace
}  // namespace inkflate
