// SPDX-License-Identifier: Apache-2.0
#include "render/draw_drawing.h"

#include <gtest/gtest.h>

#include "render/draw_mask.h"
#include "render/palette.h"
#include "render/rasterise.h"

namespace inkflate {
namespace {

/// A closed outline through the points; piece i has the kind kinds[i].
Outline straight_outline(Contour const& points, std::vector<RunKind> const& kinds) {
  Outline outline;
  for (std::size_t i = 0; i < points.size(); ++i) {
    outline.pieces.push_back({line_cubic(points[i], points[(i + 1) % points.size()]), kinds[i]});
  }
  return outline;
}

/// A square from 10 to 50 with a hole from 20 to 30; its right side is a closing, its bottom a help line.
Drawing holed_square() {
  using enum RunKind;
  Drawing drawing;
  drawing.sketch.width_px = 59.5;
  drawing.sketch.height_px = 60;
  Layer layer;
  layer.outlines.push_back(
      straight_outline({{10, 10}, {50, 10}, {50, 50}, {10, 50}}, {Ink, Closing, HelpLine, Ink}));
  layer.outlines.push_back(
      straight_outline({{20, 20}, {20, 30}, {30, 30}, {30, 20}}, {Ink, Ink, Ink, Ink}));
  drawing.layers.push_back(layer);
  return drawing;
}

TEST(DrawMask, IsInsideExactlyAtPixelCentresInside) {
  auto const mask = draw_mask(holed_square());
  EXPECT_EQ(mask.width, 60);
  EXPECT_EQ(mask.height, 60);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      bool const in_square = x >= 10 && x < 50 && y >= 10 && y < 50;
      bool const in_hole = x >= 20 && x < 30 && y >= 20 && y < 30;
      ASSERT_EQ(mask.at(x, y), in_square && !in_hole ? 255 : 0) << x << ' ' << y;
    }
  }
}

TEST(DrawMask, WhereALayerLiesOverItselfItIsThere) {
  auto drawing = holed_square();
  auto const over = straight_outline({{15, 15}, {40, 15}, {40, 40}, {15, 40}},
                                     {RunKind::Ink, RunKind::Ink, RunKind::Ink, RunKind::Ink});
  drawing.layers[0].outlines.push_back(over);
  auto const mask = draw_mask(drawing);
  EXPECT_EQ(mask.at(25, 25), 255);
  EXPECT_EQ(mask.at(35, 35), 255);
}

TEST(DrawMask, OverlappingLayersAreUnited) {
  auto drawing = holed_square();
  drawing.layers.push_back(drawing.layers[0]);
  EXPECT_EQ(draw_mask(drawing), draw_mask(holed_square()));
}

TEST(DrawDrawing, EachKindOfRunHasItsColour) {
  auto const picture = rasterise(draw_drawing(holed_square()), 60, 60, palette::kPaper);
  EXPECT_EQ(picture.at(30, 10), palette::kInk);
  // The first dot of the closing and the first dash of the help line start at their corners.
  EXPECT_EQ(picture.at(49, 15), palette::kClosing);
  EXPECT_EQ(picture.at(45, 49), palette::kHelpLine);
  EXPECT_EQ(picture.at(25, 25), palette::kPaper);
  EXPECT_NE(picture.at(40, 40), palette::kPaper);
}

TEST(DrawDrawing, RoughStrokesAppearOnlyWhenAskedFor) {
  auto drawing = holed_square();
  drawing.sketch.strokes.push_back({{{{2, 55}}, {{55, 55}}}, StrokeKind::Ink, 2, {0, 0, 0}});
  drawing.stray = {0};
  auto const hidden = rasterise(draw_drawing(drawing), 60, 60, palette::kPaper);
  EXPECT_EQ(hidden.at(20, 55), palette::kPaper);
  DrawDrawingOptions const faint = {.rough_strokes = RoughStrokes::Faint};
  auto const shown = rasterise(draw_drawing(drawing, faint), 60, 60, palette::kPaper);
  EXPECT_NE(shown.at(20, 55), palette::kPaper);
}

TEST(DrawSketch, HelpLinesAreDashedTeal) {
  Sketch const sketch = {
      100, 20, {}, {{{{{5, 10}, 1}, {{95, 10}, 1}}, StrokeKind::HelpLine, 2, {0, 0, 0}, -1}}};
  auto const picture = rasterise(draw_sketch(sketch), 100, 20, palette::kPaper);
  EXPECT_EQ(picture.at(7, 10), palette::kHelpLine);
  EXPECT_EQ(picture.at(14, 10), palette::kPaper);
}

TEST(DrawDrawing, HiddenLayersAreLeftOut) {
  auto drawing = holed_square();
  drawing.sketch.strokes = {Stroke{{{{5, 5}}, {{55, 5}}}, StrokeKind::Ink, 2, {}}};
  drawing.layers[0].strokes = drawing.layers[0].details = {0};
  drawing.layers[0].is_hidden = true;
  EXPECT_TRUE(draw_drawing(drawing, {.rough_strokes = RoughStrokes::Faint}).empty());
  EXPECT_EQ(draw_mask(drawing), Mask(60, 60));
}

TEST(DrawDrawing, ALayerWithoutOutlineIsSeenByItsStrokes) {
  auto drawing = holed_square();
  drawing.sketch.strokes = {Stroke{{{{5, 5}}, {{55, 5}}}, StrokeKind::Ink, 2, {}}};
  drawing.layers = {{"open", {}, {0}, {}}};
  auto const list = draw_drawing(drawing);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<StrokedPolyline>(list[0]));
  EXPECT_EQ(draw_mask(drawing), Mask(60, 60));
}

}  // namespace
}  // namespace inkflate
