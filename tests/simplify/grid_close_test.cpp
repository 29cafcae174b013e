// SPDX-License-Identifier: Apache-2.0
#include "simplify/grid_close.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace inkflate {
namespace {

Stroke stroke_of(std::vector<Vec2> const& points, StrokeKind kind = StrokeKind::Ink) {
  Stroke stroke;
  stroke.kind = kind;
  for (auto const p : points) stroke.samples.push_back({p, 1});
  return stroke;
}

/// A square without its right side.
Sketch open_square() {
  Sketch sketch{60, 50, {}, {}};
  sketch.strokes.push_back(stroke_of({{40.5, 10.5}, {10.5, 10.5}, {10.5, 40.5}, {40.5, 40.5}}));
  return sketch;
}

Sketch square() {
  auto sketch = open_square();
  sketch.strokes.push_back(stroke_of({{40.5, 10.5}, {40.5, 40.5}}));
  return sketch;
}

// Lines of 4 px cut corners, by less than 4 px^2 each.
constexpr double kCornersPx2 = 4 * 4;

double area_of(Outline const& outline) { return signed_area(flatten(outline, 0.1)); }

TEST(GridClose, ASquareComesBackAsDrawn) {
  auto const layers = close_on_grid(square());
  ASSERT_TRUE(layers.has_value());
  ASSERT_EQ(layers->size(), 1U);
  ASSERT_EQ(layers->front().outlines.size(), 1U);
  EXPECT_NEAR(area_of(layers->front().outlines[0]), 30 * 30, kCornersPx2);
  for (auto const& run : runs(layers->front().outlines[0], 0.1)) EXPECT_EQ(run.kind, RunKind::Ink);
}

TEST(GridClose, AHelpLineClosesAndItsRunIsTagged) {
  auto sketch = open_square();
  EXPECT_EQ(close_on_grid(sketch).error().code, ErrorCode::NothingThere);
  sketch.strokes.push_back(stroke_of({{40.5, 10.5}, {40.5, 40.5}}, StrokeKind::HelpLine));
  auto const layers = close_on_grid(sketch);
  ASSERT_TRUE(layers.has_value());
  auto const& outline = layers->front().outlines[0];
  EXPECT_NEAR(area_of(outline), 30 * 30, kCornersPx2);
  auto const found = runs(outline, 0.1);
  ASSERT_EQ(found.size(), 2U);
  auto const& help_line = found[found[0].kind == RunKind::HelpLine ? 0 : 1];
  EXPECT_EQ(help_line.kind, RunKind::HelpLine);
  // The side and, at both ends, at most a line and the pixel by which help lines are widened.
  EXPECT_GE(length(help_line.points), 30);
  EXPECT_LE(length(help_line.points), 30 + 2 * (4 + 1));
}

TEST(GridClose, LooseStrokesAndDotsAreTakenOff) {
  auto sketch = square();
  sketch.strokes.push_back(stroke_of({{40.5, 20.5}, {55.5, 25.5}}));
  sketch.strokes.push_back(stroke_of({{4, 4}}));
  auto const layers = close_on_grid(sketch);
  ASSERT_TRUE(layers.has_value());
  ASSERT_EQ(layers->size(), 1U);
  EXPECT_NEAR(area_of(layers->front().outlines[0]), 30 * 30, kCornersPx2);
}

TEST(GridClose, EveryPieceIsALayer) {
  Sketch sketch{80, 40, {}, {}};
  for (double const left : {5.0, 30.0, 55.0}) {
    sketch.strokes.push_back(
        stroke_of({{left, 10}, {left + 15, 10}, {left + 15, 30}, {left, 30}, {left, 10}}));
  }
  auto const layers = close_on_grid(sketch);
  ASSERT_TRUE(layers.has_value());
  ASSERT_EQ(layers->size(), 3U);
  for (auto const& layer : *layers) EXPECT_NEAR(area_of(layer.outlines[0]), 15 * 20, kCornersPx2);
}

TEST(GridClose, AMarkedHoleIsKeptOrFilledAsAsked) {
  auto sketch = square();
  sketch.strokes.push_back(
      stroke_of({{20.5, 20.5}, {30.5, 20.5}, {30.5, 30.5}, {20.5, 30.5}, {20.5, 20.5}}));
  GridOptions options;
  options.outside = {{25.5, 25.5}};
  auto const filled = close_on_grid(sketch, options);
  ASSERT_TRUE(filled.has_value());
  EXPECT_EQ(filled->front().outlines.size(), 1U);
  options.holes = Holes::Keep;
  auto const kept = close_on_grid(sketch, options);
  ASSERT_TRUE(kept.has_value());
  ASSERT_EQ(kept->size(), 1U);
  ASSERT_EQ(kept->front().outlines.size(), 2U);
  EXPECT_NEAR(area_of(kept->front().outlines[0]), 30 * 30, kCornersPx2);
  EXPECT_NEAR(area_of(kept->front().outlines[1]), -10 * 10, kCornersPx2);
}

TEST(GridClose, StrokesBeyondTheCanvasAreClipped) {
  Sketch sketch{50, 50, {}, {}};
  sketch.strokes.push_back(stroke_of({{-1e6, 20}, {1e6, 20}}));
  sketch.strokes.push_back(stroke_of({{-1e6, 26}, {1e6, 26}}));
  auto const layers = close_on_grid(sketch);  // 48 px of ink on both sides against 5 px of paper
  ASSERT_TRUE(layers.has_value());
  EXPECT_EQ(layers->size(), 1U);
}

TEST(GridClose, ErrorsAreNamed) {
  auto const code_of = [](Sketch const& sketch, GridOptions const& options = {}) {
    return close_on_grid(sketch, options).error().code;
  };
  EXPECT_EQ(code_of({50, 50, {}, {}}), ErrorCode::NothingThere);
  EXPECT_EQ(code_of({0, 50, {}, {}}), ErrorCode::BadInput);
  EXPECT_EQ(code_of({NAN, 50, {}, {}}), ErrorCode::BadInput);
  EXPECT_EQ(code_of({4097, 50, {}, {}}), ErrorCode::TooLarge);
  auto bad = square();
  bad.strokes.push_back(stroke_of({{1, 1}, {std::numeric_limits<double>::infinity(), 0}}));
  auto const error = close_on_grid(bad).error();
  EXPECT_EQ(error.code, ErrorCode::BadInput);
  EXPECT_EQ(error.index, 2);
  GridOptions options;
  options.weights.ink = 0;
  EXPECT_EQ(code_of(square(), options), ErrorCode::BadOption);
  options = {};
  options.min_line_length_px = NAN;
  EXPECT_EQ(code_of(square(), options), ErrorCode::BadOption);
  options = {};
  options.inside = {{NAN, 0}};
  EXPECT_EQ(code_of(square(), options), ErrorCode::BadOption);
}

TEST(GridClose, StopsWhenAsked) {
  for (int allowed = 0; allowed < 3; ++allowed) {
    int stages = 0;
    Progress const progress{{}, [&] { return stages++ >= allowed; }};
    EXPECT_EQ(close_on_grid(square(), {}, progress).error().code, ErrorCode::Cancelled);
  }
}

}  // namespace
}  // namespace inkflate
