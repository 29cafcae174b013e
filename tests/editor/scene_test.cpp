// SPDX-License-Identifier: Apache-2.0
#include "editor/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "base/rng.h"
#include "render/palette.h"
#include "support/scenes.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// Short strokes all over the canvas.
Document many_strokes(int count) {
  Rng rng(7);
  auto document = empty_document();
  for (int i = 0; i < count; ++i) {
    Vec2 const from = {rng.uniform(0, 400), rng.uniform(0, 400)};
    document = with_loose(document, line_stroke({from, from + Vec2{20, 5}, from + Vec2{30, 20}}));
  }
  return document;
}

Document discs(int count) {
  auto document = empty_document();
  for (int i = 0; i < count; ++i) document = with_disc(document, {100.0 + 20 * i, 200}, 60);
  return document;
}

ModelScene one_triangle() {
  RestModel model;
  model.mesh.points = {{-100, -100, 0}, {100, -100, 0}, {0, 100, 0}};
  model.mesh.triangles = {{0, 1, 2}};
  model.normals.assign(3, {0, 0, 1});
  model.faces = {{0, Side::Front}};
  ModelScene scene;
  scene.id = 9;
  scene.model = std::make_shared<RestModel const>(std::move(model));
  return scene;
}

/// Gathers every number of a list.
struct Finite {
  bool is = true;

  void see(double value) { is = is && std::isfinite(value); }
  void see(Vec2 p) { is = is && is_finite(p); }
  void operator()(FilledPath const& path) {
    for (auto const& contour : path.contours) {
      for (auto const p : contour) see(p);
    }
  }
  void operator()(StrokedPolyline const& line) {
    for (auto const p : line.points) see(p);
    for (double const width_px : line.widths_px) see(width_px);
    for (double const dash_px : line.dashes_px) see(dash_px);
  }
  void operator()(Dots const& dots) {
    for (auto const p : dots.centres) see(p);
  }
  void operator()(DrawnPicture const& drawn) { see(drawn.map({1, 1})); }
};

bool is_finite(Scene const& scene) {
  Finite finite;
  finite.see(scene.canvas_to_screen({1, 1}));
  for (auto const& chunk : scene.chunks) {
    for (auto const& item : *chunk.list) std::visit(finite, item);
  }
  return finite.is;
}

TEST(Scene, MovingThePaperMakesNothingAnew) {
  SceneMaker maker;
  maker.view.has_grid = true;
  maker.view.camera.centre = {230, 240};
  auto const document = with_disc(many_strokes(200), {200, 200}, 80);
  auto const before = maker.scene(document);
  maker.view.camera = panned(maker.view.camera, {3, -2});
  auto const after = maker.scene(document);
  EXPECT_EQ(new_chunks(before, after), 0);
  EXPECT_NE(before.canvas_to_screen, after.canvas_to_screen);
  // Far away other lines of the paper come into view.
  maker.view.camera = panned(maker.view.camera, {3000, 0});
  EXPECT_EQ(new_chunks(before, maker.scene(document)), 1);
}

TEST(Scene, AStrokeMoreIsOneChunkAnew) {
  SceneMaker maker;
  auto document = many_strokes(300);
  auto before = maker.scene(document);
  for (int i = 0; i < 100; ++i) {
    document = with_loose(document, line_stroke({{10.0 + i, 10}, {50.0 + i, 60}}));
    auto const after = maker.scene(document);
    EXPECT_EQ(new_chunks(before, after), 1);
    before = after;
  }
}

TEST(Scene, AnErasedStrokeLeavesMostChunksAsTheyWere) {
  SceneMaker maker;
  auto document = many_strokes(600);
  auto const before = maker.scene(document);
  document.loose = document.loose.with_replaced(100, {});
  auto const after = maker.scene(document);
  EXPECT_LE(new_chunks(before, after), 2);
  EXPECT_GE(before.chunks.size(), 10U);
}

TEST(Scene, ALayerThatChangesLeavesTheOthersAlone) {
  SceneMaker maker;
  auto const document = discs(8);
  auto const before = maker.scene(document);
  auto const changed = with_changed(document, layer_order(document)[3], [](Layer& layer) {
    layer.fill = Colour{10, 20, 30};
  });
  // Its area with its lines, and its hidden ink.
  EXPECT_EQ(new_chunks(before, maker.scene(changed)), 2);
}

TEST(Scene, ChoosingALayerDrawsNoLayerAnew) {
  SceneMaker maker;
  auto const document = discs(8);
  auto const before = maker.scene(document);
  maker.view.selection = {layer_order(document)[2]};
  auto const selected = maker.scene(document);
  EXPECT_EQ(new_chunks(before, selected), 1);
  maker.view.hover = layer_order(document)[5];
  EXPECT_EQ(new_chunks(selected, maker.scene(document)), 1);
  // One that is selected and under the pointer is shown as selected.
  maker.view.hover = maker.view.selection[0];
  EXPECT_EQ(new_chunks(selected, maker.scene(document)), 0);
}

TEST(Scene, AnIdHasOneContent) {
  SceneMaker maker;
  std::map<std::uint64_t, DrawList> seen;
  Rng rng(3);
  auto document = empty_document();
  for (int i = 0; i < 120; ++i) {
    Vec2 const p = {rng.uniform(0, 400), rng.uniform(0, 400)};
    if (i % 5 == 0) {
      document = with_disc(document, p, 30);
    } else {
      document = with_loose(document, line_stroke({p, p + Vec2{9, 9}}));
    }
    if (i % 7 == 3) document.loose = document.loose.with_replaced(0, {});
    maker.view.mode = i % 17 == 16 ? Mode::Inflate : Mode::Draw;
    maker.view.has_grid = i % 2 == 0;
    maker.view.camera.zoom = rng.uniform(0.5, 20);
    maker.view.selection = {LayerId{1 + i % 3}};
    maker.view.tool = i % 3 == 0 ? Tool::Select : Tool::Brush;
    maker.tool = i % 4 == 0 ? ToolState{ToolBoxing{p, {1, 2}, {}}} : ToolState{ToolIdle{}};
    for (auto const& chunk : maker.scene(document).chunks) {
      ASSERT_NE(chunk.id, 0U);
      ASSERT_FALSE(chunk.list->empty());
      auto const [entry, is_new] = seen.try_emplace(chunk.id, *chunk.list);
      ASSERT_TRUE(is_new || entry->second == *chunk.list) << chunk.id;
    }
  }
}

TEST(Scene, WhatIsNoLongerShownIsForgotten) {
  SceneMaker maker;
  auto document = with_loose(discs(1), line_stroke({{1, 1}, {9, 9}}));
  std::weak_ptr<DocumentLayer const> const layer = document.layers->front();
  std::weak_ptr<KeptStroke const> const stroke = document.loose[0];
  maker.scene(document);
  document = empty_document();
  EXPECT_FALSE(layer.expired());
  maker.scene(document);
  EXPECT_TRUE(layer.expired());
  EXPECT_TRUE(stroke.expired());
}

TEST(Scene, LookingCloserDrawsCurvesFiner) {
  SceneMaker maker;
  auto const document = discs(1);
  auto const points = [&](double zoom) {
    maker.view.camera.zoom = zoom;
    auto const scene = maker.scene(document);
    return std::get<FilledPath>(scene.chunks.at(0).list->at(0)).contours.at(0).size();
  };
  EXPECT_EQ(points(0.1), points(4));
  EXPECT_GT(points(5), points(4));
  EXPECT_GT(points(20), points(16));
  EXPECT_EQ(points(20), points(64));
}

TEST(Scene, AViewOfAnyNumbersGivesFiniteLists) {
  double const wild[] = {std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity(), -1e300, 1e300, 0};
  auto const document = with_open(discs(2), {line_stroke({{5, 5}, {80, 90}})});
  for (double const a : wild) {
    for (double const b : wild) {
      SceneMaker maker;
      maker.view.has_grid = true;
      maker.view.tool = Tool::Select;
      maker.view.selection = {LayerId{1}, LayerId{77}};
      maker.view.camera.zoom = a;
      maker.view.camera.centre = {b, a};
      EXPECT_TRUE(is_finite(maker.scene(document)));
      maker.view.size = {b, 40};
      auto const scene = maker.scene(document);
      EXPECT_TRUE(is_finite(scene));
      EXPECT_LE(scene.size.width_px, 16384);
      EXPECT_GE(scene.size.width_px, 0);
      if (scene.size.width_px < 100) picture_of(scene);
    }
  }
}

TEST(Scene, TellsHowMuchOfItIsFreeForAModel) {
  SceneMaker maker;
  maker.view.size = {400, 300, {0, 60, 0, 90}};
  EXPECT_EQ(free_height_px(maker.scene(empty_document()).size), 180);
}

TEST(Scene, ModelsStandOnThePaperWithoutStrokes) {
  SceneBuilder builder;
  auto view = plain_view();
  view.mode = Mode::Inflate;
  auto const document = with_loose(discs(2), line_stroke({{1, 1}, {399, 1}}));
  auto const scene = builder.build({document, view, ToolIdle{}, {}, one_triangle()});
  EXPECT_TRUE(scene.chunks.empty());
  ASSERT_TRUE(scene.model.has_value());
  EXPECT_EQ(scene.model->id, 9U);
  auto const picture = picture_of(scene);
  EXPECT_EQ(picture.at(200, 1), palette::kPaper);
  EXPECT_NE(picture.at(200, 250), palette::kPaper);
  auto hostile = one_triangle();
  hostile.view.zoom = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(picture_of(builder.build({document, view, ToolIdle{}, {}, hostile})), picture);
  hostile.model = nullptr;
  EXPECT_EQ(picture_of(builder.build({document, view, ToolIdle{}, {}, hostile})),
            Picture(400, 400, palette::kPaper));
}

TEST(Scene, InDrawModeThereIsNoModel) {
  SceneBuilder builder;
  EXPECT_FALSE(builder.build({discs(1), plain_view(), ToolIdle{}, {}, one_triangle()}).model);
}

}  // namespace
}  // namespace inkflate
