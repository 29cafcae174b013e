// SPDX-License-Identifier: Apache-2.0
#include "simplify/widest_opening.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sketches.h"

namespace inkflate {
namespace {

TEST(WidestOpening, LiesBetweenTheEndsThatAreFarthestApart) {
  // A square whose upper side has a gap of 300, its lower side one of 60.
  auto const left = line_stroke({{350, 200}, {200, 200}, {200, 800}, {470, 800}});
  auto const right = line_stroke({{650, 200}, {800, 200}, {800, 800}, {530, 800}});
  EXPECT_LT(distance(widest_opening(sketch_of({left, right})), {500, 200}), 1);
}

TEST(WidestOpening, WithoutLooseEndsIsTheMiddle) {
  EXPECT_LT(distance(widest_opening(sketch_of({circle_stroke({300, 400}, 100)})), {300, 400}), 1);
  EXPECT_EQ(widest_opening(sketch_of({line_stroke({{3, 4}})})), (Vec2{3, 4}));
  EXPECT_EQ(widest_opening({}), (Vec2{0, 0}));
}

TEST(WidestOpening, OfManyEndsIsFoundAmongTheLongStrokes) {
  std::vector<Stroke> strokes = {arc_stroke({500, 500}, 400, 400, 0, 3.14159)};
  for (int i = 0; i < 300; ++i) {
    double const x = 20 + 60.0 * (i % 16);
    double const y = 520 + 20.0 * (i / 16);
    strokes.push_back(line_stroke({{x, y - 500}, {x + 20, y - 500}}));
  }
  EXPECT_TRUE(is_finite(widest_opening(sketch_of(strokes))));
}

TEST(WidestOpening, OfHugeStrokesIsFinite) {
  EXPECT_EQ(widest_opening(sketch_of({line_stroke({{1e300, 0}, {-1e300, 0}})})), (Vec2{0, 0}));
  EXPECT_TRUE(is_finite(widest_opening(sketch_of({line_stroke({{1e6, -1e6}, {-1e6, 1e6}})}))));
}

}  // namespace
}  // namespace inkflate
