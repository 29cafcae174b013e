// SPDX-License-Identifier: Apache-2.0
#include "pipeline/run_simplify.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

Sketch square() {
  Sketch sketch = {100, 100, {}, {}};
  Stroke stroke;
  for (int i = 0; i <= 60; ++i) stroke.samples.push_back({{20.0 + i, 20}, 1});
  for (int i = 0; i <= 60; ++i) stroke.samples.push_back({{80, 20.0 + i}, 1});
  for (int i = 0; i <= 60; ++i) stroke.samples.push_back({{80.0 - i, 80}, 1});
  for (int i = 0; i <= 60; ++i) stroke.samples.push_back({{20, 80.0 - i}, 1});
  sketch.strokes.push_back(stroke);
  return sketch;
}

TEST(RunSimplify, DrawingLiesOnTheWantedCanvas) {
  RunSimplifyOptions options;
  options.place = {500, PlaceMode::FitStrokes};
  auto const drawing = run_simplify(square(), options);
  ASSERT_TRUE(drawing.has_value());
  EXPECT_EQ(drawing->sketch.width_px, 500);
  EXPECT_NEAR(drawing->sketch.strokes[0].samples[0].position.x, 35, 1e-9);
}

TEST(RunSimplify, ScanIsTracedFirst) {
  Picture picture(120, 120, Colour{255, 255, 255, 255});
  for (int i = 20; i <= 100; ++i) {
    for (int width = 0; width < 3; ++width) {
      picture.at(i, 20 + width) = picture.at(i, 98 + width) = Colour{};
      picture.at(20 + width, i) = picture.at(98 + width, i) = Colour{};
    }
  }
  auto const drawing = run_simplify(picture);
  ASSERT_TRUE(drawing.has_value());
  EXPECT_EQ(drawing->sketch.width_px, 120);
  EXPECT_FALSE(drawing->sketch.strokes.empty());
}

TEST(RunSimplify, EmptyPageIsRefused) {
  auto const drawing = run_simplify(Picture(50, 50, Colour{255, 255, 255, 255}));
  ASSERT_FALSE(drawing.has_value());
  EXPECT_EQ(drawing.error().code, ErrorCode::NothingThere);
}

TEST(RunSimplify, CancellingStopsIt) {
  auto const drawing = run_simplify(square(), {}, {{}, [] { return true; }});
  ASSERT_FALSE(drawing.has_value());
  EXPECT_EQ(drawing.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace inkflate
