// SPDX-License-Identifier: Apache-2.0
#include "simplify/quick_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kPi = 3.141592653589793;

double area(std::vector<Contour> const& contours) {
  double sum = 0;
  for (auto const& contour : contours) sum += signed_area(contour);
  return sum;
}

double area(Drawing const& drawing) {
  double sum = 0;
  for (auto const& layer : drawing.layers) {
    for (auto const& outline : layer.outlines) sum += signed_area(flatten(outline, 0.1));
  }
  return sum;
}

int closings(Drawing const& drawing) {
  int count = 0;
  for (auto const& layer : drawing.layers) {
    for (auto const& outline : layer.outlines) {
      for (auto const& run : runs(outline, 1)) count += run.kind == RunKind::Closing ? 1 : 0;
    }
  }
  return count;
}

/// Both agree on the closings and, within a share, on the area.
void expect_same(Sketch const& sketch, SimplifyOptions const& options = {}) {
  auto const quick = quick_shape(sketch, options);
  auto const full = simplify(sketch, options);
  ASSERT_EQ(quick.has_value(), full.has_value());
  if (!quick) return;
  EXPECT_EQ(std::ssize(quick->closings), closings(*full));
  EXPECT_NEAR(area(quick->contours), area(*full), 0.02 * area(*full));
  std::size_t outlines = 0;
  for (auto const& layer : full->layers) outlines += layer.outlines.size();
  EXPECT_EQ(quick->contours.size(), outlines);
  EXPECT_EQ(quick->areas.size(), outlines);
}

TEST(QuickShape, AgreesWithSimplify) {
  expect_same(sketch_of({circle_stroke({500, 500}, 300)}));
  expect_same(sketch_of({arc_stroke({500, 500}, 300, 200, 0.3, 6)}));
  expect_same(sketch_of({line_stroke({{200, 200}, {800, 200}, {800, 800}}),
                         line_stroke({{740, 800}, {200, 800}, {200, 260}})}));
  expect_same(sketch_of({circle_stroke({250, 500}, 200), circle_stroke({750, 500}, 150)}));
  expect_same(sketch_of(overdrawn(arc_stroke({500, 500}, 300, 300, 0, 5.9), 4, {3, 2})));
  expect_same(sketch_of({circle_stroke({500, 500}, 400), circle_stroke({500, 500}, 200)}));
}

TEST(QuickShape, TakesTheOptions) {
  auto const open = sketch_of({arc_stroke({500, 500}, 300, 300, 0, 5.5)});
  expect_same(open, {.gap_px = 20});
  expect_same(open, {.inside = {{500, 500}}});
  expect_same(open, {.outside = {{500, 500}}});
  auto const ring = sketch_of({circle_stroke({500, 500}, 400), circle_stroke({500, 500}, 200)});
  expect_same(ring, {.holes = Holes::Fill});
}

TEST(QuickShape, ClosingRunsFromInkToInk) {
  auto const quick = quick_shape(sketch_of({arc_stroke({500, 500}, 300, 300, 0.3, 2 * kPi)}));
  ASSERT_TRUE(quick.has_value());
  ASSERT_EQ(quick->closings.size(), 1);
  auto const& closing = quick->closings.front();
  double const gap =
      std::min(distance(closing.front(), {800, 500}), distance(closing.back(), {800, 500}));
  EXPECT_LT(gap, 15);
  EXPECT_NEAR(distance(closing.front(), closing.back()), 90, 20);
}

TEST(QuickShape, EachGroupIsAnArea) {
  auto sketch = sketch_of({circle_stroke({400, 500}, 200), circle_stroke({600, 500}, 200),
                           circle_stroke({500, 500}, 400)});
  sketch.groups = {{"body"}, {"arm"}, {"noise"}};
  for (int i = 0; i < 3; ++i) sketch.strokes[i].group = i;
  auto const quick = quick_shape(sketch, {.parts = Parts::Groups});
  ASSERT_TRUE(quick.has_value());
  EXPECT_EQ(quick->areas, (std::vector<int>{0, 1}));
}

TEST(QuickShape, OfManySamplesIsNearlyTheSame) {
  std::vector<Stroke> strokes = overdrawn(arc_stroke({500, 500}, 450, 400, 0, 6), 20, {0.6, 0.3});
  auto const hatches = overdrawn(line_stroke({{400, 300}, {600, 700}}), 20, {1, 0.5});
  strokes.insert(strokes.end(), hatches.begin(), hatches.end());
  expect_same(sketch_of(strokes));
}

TEST(QuickShape, RefusesWhatSimplifyRefuses) {
  auto const code = [](Sketch const& sketch, SimplifyOptions const& options = {}) {
    auto const quick = quick_shape(sketch, options);
    EXPECT_FALSE(quick.has_value());
    return quick ? ErrorCode::FileSystem : quick.error().code;
  };
  auto const circle = sketch_of({circle_stroke({500, 500}, 100)});
  EXPECT_EQ(code({}), ErrorCode::NothingThere);
  EXPECT_EQ(code(sketch_of({line_stroke({{0, 0}, {100, 3}})})), ErrorCode::NothingThere);
  EXPECT_EQ(code(circle, {.gap_px = -1}), ErrorCode::BadOption);
  EXPECT_EQ(code(circle, {.inside = {{900, 900}}}), ErrorCode::BadOption);
  EXPECT_EQ(code(sketch_of({line_stroke({{NAN, 0}})})), ErrorCode::BadInput);
}

TEST(QuickShape, PassesOverMarksBeyondTheStrokesOnRequest) {
  auto const circle = sketch_of({circle_stroke({500, 500}, 100)});
  EXPECT_TRUE(quick_shape(circle, {.inside = {{900, 900}}, .marks_beyond = MarksBeyond::PassOver})
                  .has_value());
}

TEST(QuickShape, CanBeCancelledAtEveryStage) {
  auto const circle = sketch_of({circle_stroke({500, 500}, 100)});
  int stages = 0;
  ASSERT_TRUE(quick_shape(circle, {}, {[&](auto) { ++stages; }, {}}).has_value());
  EXPECT_GT(stages, 4);
  for (int stop = 0; stop < stages; ++stop) {
    int seen = 0;
    auto const result = quick_shape(circle, {}, {{}, [&] { return seen++ == stop; }});
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
  }
}

TEST(QuickShape, OfAnyDrawingIsFiniteAndTheSameAgain) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    auto const sketch = random_sketch(seed);
    auto const quick = quick_shape(sketch);
    EXPECT_EQ(quick.has_value(), simplify(sketch).has_value()) << seed;
    if (!quick) continue;
    for (auto const& contour : quick->contours) {
      EXPECT_GE(contour.size(), 3U);
      for (auto const p : contour) EXPECT_TRUE(is_finite(p)) << seed;
    }
    EXPECT_EQ(quick->contours, quick_shape(sketch)->contours);
  }
}

}  // namespace
}  // namespace inkflate
