// SPDX-License-Identifier: Apache-2.0
#include "pipeline/place_sketch.h"

#include <gtest/gtest.h>

#include <limits>

namespace inkflate {
namespace {

Stroke stroke_through(std::vector<Vec2> const& points) {
  Stroke stroke;
  for (auto const p : points) stroke.samples.push_back({p, 1});
  return stroke;
}

PlaceOptions fit(double size_px) { return {size_px, PlaceMode::FitStrokes}; }

TEST(PlaceSketch, FitGivesTheLongerSideItsShareAndCentresIt) {
  Sketch const sketch = {400, 300, {}, {stroke_through({{10, 20}, {210, 120}})}};
  auto const placed = place_sketch(sketch, fit(1000));
  ASSERT_TRUE(placed.has_value());
  auto const& samples = placed->strokes[0].samples;
  EXPECT_DOUBLE_EQ(samples[0].position.x, 70);
  EXPECT_DOUBLE_EQ(samples[1].position.x, 930);
  EXPECT_DOUBLE_EQ(samples[0].position.y, 285);
  EXPECT_DOUBLE_EQ(samples[1].position.y, 715);
  EXPECT_EQ(placed->width_px, 1000);
  EXPECT_EQ(placed->height_px, 1000);
}

TEST(PlaceSketch, FitDoesNotCountDots) {
  Sketch sketch = {400, 300, {}, {stroke_through({{10, 20}, {210, 120}})}};
  auto const without = place_sketch(sketch, fit(500));
  sketch.strokes.push_back(stroke_through({{399, 299}}));
  auto const with = place_sketch(sketch, fit(500));
  EXPECT_EQ(without->strokes[0], with->strokes[0]);
}

TEST(PlaceSketch, WidthsAreScaledWithTheStrokes) {
  Sketch sketch = {100, 100, {}, {stroke_through({{0, 0}, {86, 0}})}};
  sketch.strokes[0].width_px = 3;
  EXPECT_DOUBLE_EQ(place_sketch(sketch, fit(200))->strokes[0].width_px, 6);
}

TEST(PlaceSketch, FitOfStrokesWithoutExtentOnlyCentres) {
  Sketch const sketch = {100, 100, {}, {stroke_through({{7, 7}, {7, 7}})}};
  auto const placed = place_sketch(sketch, fit(50));
  EXPECT_EQ(placed->strokes[0].samples[0].position, (Vec2{25, 25}));
}

TEST(PlaceSketch, FitWithoutSizeUsesTheLongerSideOfTheCanvas) {
  Sketch const sketch = {400, 300, {}, {stroke_through({{0, 0}, {10, 0}})}};
  auto const placed = place_sketch(sketch, {{}, PlaceMode::FitStrokes});
  EXPECT_EQ(placed->height_px, 400);
  EXPECT_DOUBLE_EQ(placed->strokes[0].samples[1].position.x, 372);
}

TEST(PlaceSketch, SizeAloneScalesTheWholeCanvas) {
  Sketch const sketch = {400, 300, {}, {stroke_through({{40, 30}, {80, 90}})}};
  auto const placed = place_sketch(sketch, {200, PlaceMode::WholeCanvas});
  EXPECT_EQ(placed->width_px, 200);
  EXPECT_EQ(placed->height_px, 150);
  EXPECT_EQ(placed->strokes[0].samples[1].position, (Vec2{40, 45}));
}

TEST(PlaceSketch, NothingAskedChangesNothing) {
  Sketch const sketch = {400, 300, {}, {stroke_through({{40, 30}, {80, 90}})}};
  EXPECT_EQ(*place_sketch(sketch, {}), sketch);
}

TEST(PlaceSketch, SizeOutOfRangeIsRefused) {
  for (double const size_px : {0.0, -5.0, 16385.0, std::numeric_limits<double>::quiet_NaN()}) {
    auto const placed = place_sketch({}, fit(size_px));
    ASSERT_FALSE(placed.has_value());
    EXPECT_EQ(placed.error().code, ErrorCode::BadOption);
  }
}

TEST(PlaceSketch, CanvasWithoutSizeCannotBeScaled) {
  auto const placed = place_sketch({}, {100, PlaceMode::WholeCanvas});
  ASSERT_FALSE(placed.has_value());
  EXPECT_EQ(placed.error().code, ErrorCode::NothingThere);
}

}  // namespace
}  // namespace inkflate
