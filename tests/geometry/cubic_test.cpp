// SPDX-License-Identifier: Apache-2.0
#include "geometry/cubic.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

Cubic const kArch = {{Vec2{0, 0}, Vec2{10, 60}, Vec2{50, 80}, Vec2{90, 10}}};

TEST(Cubic, SplitHalvesAreTheSameCurve) {
  auto const [first, second] = split(kArch, 0.3);
  for (double const t : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_LT(distance(point_at(first, t), point_at(kArch, 0.3 * t)), 1e-12);
    EXPECT_LT(distance(point_at(second, t), point_at(kArch, 0.3 + 0.7 * t)), 1e-12);
  }
}

TEST(Cubic, FlattenedChordsStayWithinTolerance) {
  double const tolerance_px = 0.1;
  std::vector<Vec2> points = {kArch.start()};
  flatten_into(kArch, tolerance_px, points);
  EXPECT_EQ(points.back(), kArch.end());
  int const count = static_cast<int>(points.size()) - 1;
  for (int i = 0; i < count; ++i) {
    auto const middle = point_at(kArch, (i + 0.5) / count);
    EXPECT_LT(distance(middle, lerp(points[i], points[i + 1], 0.5)), tolerance_px);
  }
}

TEST(Cubic, QuadraticIsTheSameCurveRaised) {
  auto const raised = quadratic_cubic({0, 0}, {10, 20}, {40, 0});
  EXPECT_LT(distance(point_at(raised, 0.5), Vec2{15, 10}), 1e-12);
}

}  // namespace
}  // namespace inkflate
