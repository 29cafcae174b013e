// SPDX-License-Identifier: Apache-2.0
#include "render/bake_texture.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "geometry/rect.h"
#include "render/palette.h"
#include "support/render_models.h"

namespace inkflate {
namespace {

constexpr Colour kApricot = {255, 200, 120};
constexpr Colour kSky = {150, 210, 255};
constexpr Colour kBlack = {0, 0, 0};

/// Two discs that overlap; a stroke lies across the middle of each, those of the first also beyond its rim.
struct TwoDiscs {
  Drawing drawing;
  RestModel model = empty_model(400, 300);

  TwoDiscs() {
    drawing.sketch.width_px = 400;
    drawing.sketch.height_px = 300;
    add_disc(drawing, {150, 150}, 100).fill = kApricot;
    add_ball(model, {{150, 150}, 100, 0, 8, 24});
    add_disc(drawing, {250, 150}, 80).fill = kSky;
    add_ball(model, {{250, 150}, 80, 100, 8, 24});
    add_detail(drawing, 0, {120, 150}, {390, 150}, kBlack, 10);
  }
};

/// The texel that a place of the canvas gets on one sheet, by the triangle that covers it.
Colour worn_at(TwoDiscs const& discs, Texture const& texture, Face face, Vec2 place) {
  for (std::size_t t = 0; t < discs.model.faces.size(); ++t) {
    if (discs.model.faces[t] != face) continue;
    auto const& corners = discs.model.mesh.triangles[t];
    auto const at = [&](std::size_t k) {
      return discs.model.canvas[static_cast<std::size_t>(corners[k])];
    };
    double const area = cross(at(1) - at(0), at(2) - at(0));
    double const u = cross(place - at(0), at(2) - at(0)) / area;
    double const v = cross(at(1) - at(0), place - at(0)) / area;
    if (u < 0 || v < 0 || u + v > 1) continue;
    auto const& worn = texture.corners[t];
    Vec2 const spot = worn[0] + u * (worn[1] - worn[0]) + v * (worn[2] - worn[0]);
    return texture.picture.at(static_cast<int>(spot.x * texture.picture.width),
                              static_cast<int>(spot.y * texture.picture.height));
  }
  ADD_FAILURE() << "no triangle at " << place.x << ' ' << place.y;
  return {};
}

/// Where the triangles of each layer and side lie, in texels.
std::vector<Rect> texel_boxes(RestModel const& model, Texture const& texture) {
  std::vector<Rect> boxes(2 * model.layer_names.size());
  for (std::size_t t = 0; t < model.faces.size(); ++t) {
    auto const [layer, side] = model.faces[t];
    auto& box = boxes[static_cast<std::size_t>(2 * layer + (side == Side::Back ? 1 : 0))];
    for (auto const corner : texture.corners[t]) {
      box.include({corner.x * texture.picture.width, corner.y * texture.picture.height});
    }
  }
  return boxes;
}

TEST(BakeTexture, EachLayerWearsItsColourAndOnlyItsOwnInk) {
  TwoDiscs const discs;
  auto const texture = bake_texture(discs.drawing, discs.model);
  EXPECT_EQ(worn_at(discs, texture, {0, Side::Front}, {150, 120}), kApricot);
  EXPECT_EQ(worn_at(discs, texture, {1, Side::Front}, {250, 120}), kSky);
  EXPECT_EQ(worn_at(discs, texture, {0, Side::Front}, {200, 150}), kBlack);
  EXPECT_EQ(worn_at(discs, texture, {1, Side::Front}, {250, 150}), kSky);
}

TEST(BakeTexture, DetailsAreOnTheBackOnlyWhenAskedFor) {
  TwoDiscs const discs;
  auto const hidden = bake_texture(discs.drawing, discs.model);
  EXPECT_EQ(worn_at(discs, hidden, {0, Side::Back}, {200, 150}), kApricot);
  BakeOptions options;
  options.back_details = BackDetails::Shown;
  auto const shown = bake_texture(discs.drawing, discs.model, options);
  EXPECT_EQ(worn_at(discs, shown, {0, Side::Back}, {200, 150}), kBlack);
}

TEST(BakeTexture, TheOutlineIsOnBothSidesInBothLooks) {
  TwoDiscs const discs;
  for (auto const look : {OutlineLook::Rough, OutlineLook::Clean}) {
    BakeOptions options;
    options.outline = look;
    auto const texture = bake_texture(discs.drawing, discs.model, options);
    for (auto const side : {Side::Front, Side::Back}) {
      EXPECT_LT(worn_at(discs, texture, {0, side}, {150, 50.4}).r, 60);
    }
  }
}

TEST(BakeTexture, ALayerWithoutColourIsOfThePalettesSkin) {
  TwoDiscs discs;
  discs.drawing.layers[0].fill.reset();
  auto const texture = bake_texture(discs.drawing, discs.model);
  EXPECT_EQ(worn_at(discs, texture, {0, Side::Front}, {150, 120}), palette::kSkin);
}

TEST(BakeTexture, NoTriangleComesNearAnothersRectangle) {
  TwoDiscs const discs;
  BakeOptions options;
  auto const texture = bake_texture(discs.drawing, discs.model, options);
  auto const boxes = texel_boxes(discs.model, texture);
  double const gap = 2 * options.padding - 1e-6;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].min.x, options.padding - 1e-6);
    EXPECT_LE(boxes[i].max.y, texture.picture.height - options.padding + 1e-6);
    for (std::size_t k = 0; k < i; ++k) {
      if (boxes[i] == boxes[k]) continue;  // front and back that look the same
      EXPECT_TRUE(boxes[i].min.x - boxes[k].max.x >= gap ||
                  boxes[k].min.x - boxes[i].max.x >= gap ||
                  boxes[i].min.y - boxes[k].max.y >= gap || boxes[k].min.y - boxes[i].max.y >= gap);
    }
  }
}

TEST(BakeTexture, SheetsShareARectangleWhereTheyLookTheSame) {
  TwoDiscs const discs;
  auto const boxes = texel_boxes(discs.model, bake_texture(discs.drawing, discs.model));
  EXPECT_NE(boxes[0], boxes[1]);
  EXPECT_EQ(boxes[2], boxes[3]);
}

TEST(BakeTexture, TrianglesKeepTheShapeThatTheyHaveOnTheCanvas) {
  TwoDiscs const discs;
  double const texels_per_px = 1.25;
  auto const texture = bake_texture(discs.drawing, discs.model, {.texels_per_px = texels_per_px});
  for (std::size_t t = 0; t < discs.model.faces.size(); ++t) {
    auto const& corners = discs.model.mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      auto const place = [&](std::size_t i) {
        return discs.model.canvas[static_cast<std::size_t>(corners[i % 3])];
      };
      Vec2 const worn = texture.corners[t][(k + 1) % 3] - texture.corners[t][k];
      EXPECT_NEAR(worn.x * texture.picture.width, texels_per_px * (place(k + 1) - place(k)).x,
                  1e-9);
      EXPECT_NEAR(worn.y * texture.picture.height, texels_per_px * (place(k + 1) - place(k)).y,
                  1e-9);
    }
  }
}

TEST(BakeTexture, ALargeCanvasGetsFewerTexelsForEachPx) {
  TwoDiscs discs;
  for (auto& place : discs.model.canvas) place = 50 * place;
  BakeOptions options;
  options.longest_side = 300;
  auto const texture = bake_texture(discs.drawing, discs.model, options);
  EXPECT_LE(std::max(texture.picture.width, texture.picture.height), 300);
  EXPECT_GE(std::max(texture.picture.width, texture.picture.height), 240);
}

TEST(BakeTexture, LayersThatTheDrawingLacksArePlain) {
  TwoDiscs discs;
  discs.drawing.layers.pop_back();
  auto const texture = bake_texture(discs.drawing, discs.model);
  EXPECT_EQ(worn_at(discs, texture, {1, Side::Front}, {250, 150}), palette::kSkin);
}

TEST(BakeTexture, AModelWithoutTrianglesStillHasAPicture) {
  auto const texture = bake_texture({}, empty_model(400, 300));
  EXPECT_EQ(texture.picture.width, 1);
  EXPECT_TRUE(texture.corners.empty());
}

TEST(WearPicture, TheWholeCanvasIsThePicture) {
  TwoDiscs const discs;
  auto const texture = wear_picture(Picture(8, 6, kSky), discs.model);
  EXPECT_EQ(texture.picture, Picture(8, 6, kSky));  // of the canvas' shape
  for (std::size_t t = 0; t < texture.corners.size(); ++t) {
    auto const vertex = static_cast<std::size_t>(discs.model.mesh.triangles[t][0]);
    EXPECT_EQ(texture.corners[t][0].x, discs.model.canvas[vertex].x / 400);
    EXPECT_EQ(texture.corners[t][0].y, discs.model.canvas[vertex].y / 300);
  }
}

TEST(WearPicture, APictureOfAnotherShapeKeepsItAndLiesInTheMiddle) {
  TwoDiscs const discs;
  // 300 x 300 px of the canvas, which is 400 x 300.
  auto const texture = wear_picture(Picture(5, 5, kSky), discs.model);
  for (std::size_t t = 0; t < texture.corners.size(); ++t) {
    auto const place =
        discs.model.canvas[static_cast<std::size_t>(discs.model.mesh.triangles[t][0])];
    EXPECT_NEAR(texture.corners[t][0].x, std::clamp((place.x - 50) / 300, 0.0, 1.0), 1e-12);
    EXPECT_NEAR(texture.corners[t][0].y, place.y / 300, 1e-12);
  }
}

}  // namespace
}  // namespace inkflate
