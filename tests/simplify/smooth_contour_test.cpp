// SPDX-License-Identifier: Apache-2.0
#include "simplify/smooth_contour.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/rng.h"
#include "geometry/vec2.h"

namespace inkflate {
namespace {

std::vector<double> random_values(Rng& rng) {
  std::vector<double> values(static_cast<std::size_t>(1 + rng.below(60)));
  for (auto& value : values) value = rng.uniform(-5, 5);
  return values;
}

/// Three moving averages by the definition.
std::vector<double> averaged(std::vector<double> values, int radius) {
  int const count = static_cast<int>(std::ssize(values));
  radius = std::min(radius, (count - 1) / 2);
  for (int pass = 0; pass < 3; ++pass) {
    auto const before = values;
    for (int i = 0; i < count; ++i) {
      double sum = 0;
      for (int k = -radius; k <= radius; ++k) sum += before[(i + k + count) % count];
      values[i] = sum / (2 * radius + 1);
    }
  }
  return values;
}

TEST(SmoothClosed, IsThreeMovingAverages) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    auto values = random_values(rng);
    int const radius = rng.below(12);
    auto const expected = averaged(values, radius);
    smooth_closed(values, radius);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-12);
  }
}

TEST(SmoothClosed, ConstantsAndSumsStay) {
  std::vector<Vec2> constant(20, Vec2{3, -7});
  smooth_closed(constant, 4);
  for (auto const p : constant) EXPECT_LT(distance(p, {3, -7}), 1e-12);
  Rng rng(1);
  auto values = random_values(rng);
  double const sum = std::accumulate(values.begin(), values.end(), 0.0);
  smooth_closed(values, 5);
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), sum, 1e-10);
}

TEST(SmoothOpen, BothEndsStay) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    auto values = random_values(rng);
    auto const before = values;
    smooth_open(values, rng.below(12));
    EXPECT_EQ(values.front(), before.front());
    EXPECT_EQ(values.back(), before.back());
  }
}

TEST(SmoothOpen, StraightLinesStay) {
  for (int const count : {2, 3, 7, 40}) {
    std::vector<Vec2> line;
    for (int i = 0; i < count; ++i) line.push_back({2.0 * i, 5 - 0.5 * i});
    auto const before = line;
    smooth_open(line, 6);
    for (int i = 0; i < count; ++i) EXPECT_LT(distance(line[i], before[i]), 1e-12);
  }
}

TEST(Smooth, ZigzagIsAlmostGoneAndNoRadiusChangesNothing) {
  std::vector<double> zigzag(41);
  for (std::size_t i = 0; i < zigzag.size(); ++i) zigzag[i] = i % 2 == 0 ? 1 : -1;
  auto open = zigzag;
  smooth_open(open, 2);
  for (std::size_t i = 8; i + 8 < open.size(); ++i) EXPECT_LT(std::abs(open[i]), 0.02);
  auto same = zigzag;
  smooth_open(same, 0);
  smooth_closed(same, 0);
  EXPECT_EQ(same, zigzag);
}

TEST(Smooth, NothingAndSinglesAreLeftAlone) {
  std::vector<double> none;
  smooth_closed(none, 3);
  smooth_open(none, 3);
  std::vector<double> one = {4};
  smooth_closed(one, 3);
  smooth_open(one, 3);
  EXPECT_EQ(one, std::vector<double>{4});
}

}  // namespace
}  // namespace inkflate
