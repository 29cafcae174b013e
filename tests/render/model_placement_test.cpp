// SPDX-License-Identifier: Apache-2.0
#include "render/model_placement.h"

#include <gtest/gtest.h>

#include "render/ground_shadow.h"
#include "support/render_models.h"

namespace inkflate {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 400;

RestModel ball() {
  auto model = empty_model(400, 300);
  add_ball(model, {{150, 200}, 60, 10, 12, 36});
  return model;
}

Vec3 mapped(SpaceMap const& map, Vec3 p) {
  auto const row = [&](std::size_t i) {
    return map[i] * p.x + map[i + 1] * p.y + map[i + 2] * p.z + map[i + 3];
  };
  return {row(0), row(4), row(8)};
}

TEST(ModelPlacement, ItsMapPutsEachPointWhereDrawModelDoes) {
  auto const model = ball();
  ModelView const view = {0.7, -0.3, 1.5, {20, -35}};
  auto const list = draw_model(model, nullptr, view, Shading::Matcap, kWidth, kHeight);
  auto const placement = model_placement(model, view, kWidth, kHeight);
  auto const map = to_view(placement, kWidth, kHeight);
  Rect box;
  for (std::size_t i = 0; i < list.positions.size(); ++i) {
    auto const drawn = list.positions[i];
    box.include({drawn.x, drawn.y});
    Vec3 const expected = {kWidth / 2.0 + drawn.x, kHeight / 2.0 - drawn.y, drawn.z};
    ASSERT_LT(distance(mapped(map, model.mesh.points[i]), expected), 1e-9);
  }
  EXPECT_LT(distance(box.min, placement.box.min), 1e-9);
  EXPECT_LT(distance(box.max, placement.box.max), 1e-9);
}

TEST(ModelPlacement, TurningAModelThatIsFittedFromItsFrontKeepsItsSizeAndItsMiddle) {
  auto const model = ball();
  auto const of = [&](ModelView const& view) {
    return model_placement(model, view, kWidth, kHeight, ModelFit::FromFront);
  };
  auto const front = of({});
  EXPECT_EQ(front.box, model_placement(model, {}, kWidth, kHeight).box);
  auto const middle = front.centre;  // from the front the model's own space is that of the view
  for (double const turn : {-2.0, 0.4, 1.5}) {
    auto const turned = of({turn, 0.3, 1, {}});
    EXPECT_EQ(turned.scale, front.scale);
    EXPECT_LT(norm(turned(middle)), 1e-9);
  }
}

TEST(ModelPlacement, OnThePaperEachVertexLiesWhereItWasDrawn) {
  auto const model = ball();
  Affine const canvas_to_view = {-2, 0, 0, 2, 500, 30};  // mirrored
  auto const map = onto_paper(model, canvas_to_view);
  double nearest = -1e9;
  double farthest = 1e9;
  for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
    auto const p = mapped(map, model.mesh.points[i]);
    ASSERT_LT(distance({p.x, p.y}, canvas_to_view(model.canvas[i])), 1e-9);
    nearest = std::max(nearest, p.z);
    farthest = std::min(farthest, p.z);
  }
  EXPECT_GT(nearest, farthest);
  EXPECT_LT(nearest - farthest, 5);
}

TEST(ModelPlacement, AModelWithoutPointsHasNoBox) {
  auto const placement = model_placement(empty_model(100, 100), {}, kWidth, kHeight);
  EXPECT_TRUE(placement.box.is_empty());
  EXPECT_EQ(placement.scale, 1);
}

TEST(ShadowEllipse, IsWhereTheShadowIsDrawn) {
  auto const list = draw_model(ball(), nullptr, {}, Shading::Matcap, kWidth, kHeight);
  Picture picture(kWidth, kHeight, {0, 0, 0, 0});
  draw_ground_shadow(list, picture);
  auto const placement = model_placement(ball(), {}, kWidth, kHeight);
  auto const ellipse = shadow_ellipse(placement.box, kWidth, kHeight);
  int inside = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (picture.at(x, y).a == 0) continue;
      ++inside;
      auto const d = Vec2{x + 0.5, y + 0.5} - ellipse.centre;
      Vec2 const reach = {d.x / ellipse.half_axes_px.x, d.y / ellipse.half_axes_px.y};
      ASSERT_LT(norm(reach), 1);
    }
  }
  EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace inkflate
