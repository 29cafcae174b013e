// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "geometry/crossings.h"
#include "simplify/simplify.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

bool every_outline_is_simple(Drawing const& drawing, double tolerance_px) {
  for (auto const& layer : drawing.layers) {
    for (auto const& outline : layer.outlines) {
      if (!is_simple(flatten(outline, tolerance_px))) return false;
    }
  }
  return true;
}

// It was simple at 0.01 work px, but two sides are so close that a polygon at 0.2 work px crossed.
TEST(SimplifyRegression, NarrowPlacesStaySimpleInCoarsePolygons) {
  SimplifyOptions const options = {.gap_px = 152.157, .parts = Parts::One, .smooth = 1};
  auto const drawing = simplify(random_sketch(391), options);
  ASSERT_TRUE(drawing.has_value());
  EXPECT_TRUE(every_outline_is_simple(*drawing, 0.127));
}

// One pixel of this shape is a hundred thousand times as long as the strokes; giving them to it looked at outline points as dense
// as the strokes' own, and took seconds.
TEST(SimplifyRegression, TheGridSortsStrokesFarSmallerThanAPixel) {
  Sketch sketch = sketch_of({circle_stroke({40.5, 40.5}, 1e-5), circle_stroke({40.5, 40.5}, 1e-5)});
  sketch.width_px = 80;
  sketch.height_px = 80;
  auto const drawing = simplify(sketch, {.method = SimplifyMethod::Grid, .inside = {{20, 20}}});
  ASSERT_TRUE(drawing.has_value());
  EXPECT_EQ(what_is_wrong(*drawing), "");
}

// Doubles have few digits left for the shape so far out.
TEST(SimplifyRegression, ATinyShapeFarOutIsValidOrRefused) {
  for (double const radius : {1e-2, 1e-3, 1e-4, 1e-6}) {
    auto circle = circle_stroke({0, 0}, radius);
    for (auto& sample : circle.samples) sample.position += Vec2{-9e5, 7e5};
    auto const drawing = simplify(sketch_of({circle}));
    if (drawing) {
      EXPECT_EQ(what_is_wrong(*drawing), "") << radius;
    } else {
      EXPECT_EQ(drawing.error().code, ErrorCode::NothingThere) << radius;
    }
  }
}

}  // namespace
}  // namespace inkflate
