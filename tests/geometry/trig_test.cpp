// SPDX-License-Identifier: Apache-2.0
#include "geometry/trig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/rng.h"

namespace inkflate {
namespace {

constexpr double kTolerance = 1e-12;

TEST(Trig, SineAndCosineAgreeWithTheLibrary) {
  Rng rng(1);
  for (double const range : {0.8, 7.0, 1000.0, 1e6}) {
    for (int i = 0; i < 2000; ++i) {
      double const angle = rng.uniform(-range, range);
      auto const [s, c] = sin_cos(angle);
      ASSERT_NEAR(s, std::sin(angle), kTolerance) << angle;
      ASSERT_NEAR(c, std::cos(angle), kTolerance) << angle;
    }
  }
}

TEST(Trig, QuarterTurnsAreExactToRounding) {
  for (int i = -8; i <= 8; ++i) {
    auto const [s, c] = sin_cos(i * kPi / 2);
    EXPECT_NEAR(s, std::sin(i * kPi / 2), 1e-15);
    EXPECT_NEAR(c, std::cos(i * kPi / 2), 1e-15);
  }
}

TEST(Trig, AnglesOutOfRangeAreNoTurn) {
  for (double const angle : {1e300, -2e6, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(sin_cos(angle).sin, 0);
    EXPECT_EQ(sin_cos(angle).cos, 1);
  }
}

TEST(Trig, AngleOfAPointAgreesWithTheLibrary) {
  Rng rng(2);
  for (int i = 0; i < 5000; ++i) {
    double const x = rng.uniform(-1, 1) * (i % 3 == 0 ? 1e-9 : 1);
    double const y = rng.uniform(-1, 1) * (i % 5 == 0 ? 1e300 : 1);
    ASSERT_NEAR(atan2_of(y, x), std::atan2(y, x), kTolerance) << y << ' ' << x;
  }
}

TEST(Trig, AngleOnTheAxesIsTheQuarter) {
  EXPECT_EQ(atan2_of(0, 0), 0);
  EXPECT_EQ(atan2_of(0, 3), 0);
  EXPECT_EQ(atan2_of(0, -3), kPi);
  EXPECT_EQ(atan2_of(-0.0, -3), kPi);
  EXPECT_EQ(atan2_of(2, 0), kPi / 2);
  EXPECT_EQ(atan2_of(-2, 0), -kPi / 2);
}

TEST(Trig, ArcCosineAgreesWithTheLibrary) {
  Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    double const c = rng.uniform(-1, 1);
    ASSERT_NEAR(acos_of(c), std::acos(c), kTolerance) << c;
  }
  EXPECT_EQ(acos_of(1.5), 0);
  EXPECT_EQ(acos_of(-1.5), kPi);
}

}  // namespace
}  // namespace inkflate
