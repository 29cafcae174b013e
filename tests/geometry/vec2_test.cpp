// SPDX-License-Identifier: Apache-2.0
#include "geometry/vec2.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/rng.h"

namespace inkflate {
namespace {

TEST(Vec2, PerpendicularTurnsXToY) {
  EXPECT_EQ(perpendicular({1, 0}), (Vec2{0, 1}));
  EXPECT_EQ(perpendicular({0, 1}), (Vec2{-1, 0}));
  EXPECT_GT(cross({1, 0}, {0, 1}), 0);
}

TEST(Vec2, DotAndCrossSplitTheProductOfLengths) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    Vec2 const a = {rng.uniform(-9, 9), rng.uniform(-9, 9)};
    Vec2 const b = {rng.uniform(-9, 9), rng.uniform(-9, 9)};
    double const product = squared_norm(a) * squared_norm(b);
    EXPECT_NEAR(dot(a, b) * dot(a, b) + cross(a, b) * cross(a, b), product, 1e-12 * product);
    EXPECT_EQ(dot(perpendicular(a), b), cross(a, b));
  }
}

TEST(Vec2, NormalizedHasLengthOneOrZero) {
  EXPECT_NEAR(norm(normalized({3, -4})), 1, 1e-15);
  EXPECT_EQ(normalized({0, 0}), (Vec2{0, 0}));
}

TEST(Vec2, LerpIsExactAtItsStart) {
  Vec2 const a = {0.1, 0.7};
  EXPECT_EQ(lerp(a, {5, 3}, 0), a);
  EXPECT_EQ(lerp({0, 8}, {4, 0}, 0.25), (Vec2{1, 6}));
}

TEST(Vec2, FiniteMeansBothCoordinates) {
  double const infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_finite({1, 2}));
  EXPECT_FALSE(is_finite({infinity, 0}));
  EXPECT_FALSE(is_finite({0, -infinity}));
  EXPECT_FALSE(is_finite({0, std::numeric_limits<double>::quiet_NaN()}));
}

}  // namespace
}  // namespace inkflate
