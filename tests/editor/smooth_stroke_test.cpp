// SPDX-License-Identifier: Apache-2.0
#include "editor/smooth_stroke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr double kHalfWindowPx = 8;

std::vector<Sample> samples_of(std::vector<Vec2> const& points) {
  std::vector<Sample> samples;
  for (auto const p : points) samples.push_back({p, 1, 0});
  return samples;
}

std::vector<Sample> smoothed(std::vector<Sample> const& raw, double half_width_px = kHalfWindowPx) {
  std::vector<Sample> smooth;
  smooth_end(raw, half_width_px, smooth);
  return smooth;
}

/// To the right, one sample each 2 px, off the line by a few px to and fro.
std::vector<Sample> trembling_line() {
  Rng rng(7);
  std::vector<Vec2> points;
  for (int i = 0; i <= 200; ++i) points.push_back({2.0 * i, 1.5 * (2 * rng.uniform() - 1)});
  return samples_of(points);
}

double largest_y(std::vector<Sample> const& samples) {
  double largest = 0;
  for (auto const& sample : samples) largest = std::max(largest, std::abs(sample.position.y));
  return largest;
}

double sum_of_squares(std::vector<Sample> const& samples) {
  double sum = 0;
  for (auto const& sample : samples) sum += sample.position.y * sample.position.y;
  return sum;
}

TEST(SmoothStroke, TakesOutMostOfATremble) {
  auto const raw = trembling_line();
  auto const smooth = smoothed(raw);
  ASSERT_EQ(smooth.size(), raw.size());
  EXPECT_LT(sum_of_squares(smooth), 0.3 * sum_of_squares(raw));
  EXPECT_LT(largest_y(smooth), largest_y(raw));
  EXPECT_LT(sum_of_squares(smoothed(raw, 2 * kHalfWindowPx)), sum_of_squares(smooth));
}

TEST(SmoothStroke, StartsAndEndsExactlyAtThePen) {
  auto const raw = trembling_line();
  for (std::size_t count = 1; count <= raw.size(); ++count) {
    std::vector<Sample> const part(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(count));
    auto const smooth = smoothed(part);
    EXPECT_EQ(smooth.front().position, part.front().position);
    EXPECT_EQ(smooth.back().position, part.back().position);
  }
}

TEST(SmoothStroke, SampleBySampleIsAllAtOnce) {
  auto const raw = trembling_line();
  std::vector<Sample> growing;
  std::vector<Sample> smooth;
  for (auto const& sample : raw) {
    growing.push_back(sample);
    smooth_end(growing, kHalfWindowPx, smooth);
  }
  EXPECT_EQ(smooth, smoothed(raw));
}

TEST(SmoothStroke, LeavesStraightLinesHoweverUnevenTheirSamples) {
  Rng rng(3);
  std::vector<Vec2> points = {{0, 0}};
  while (points.size() < 100) points.push_back(points.back() + Vec2{3, 4} * (4 * rng.uniform()));
  for (auto const& sample : smoothed(samples_of(points))) {
    EXPECT_NEAR(cross(sample.position, {0.6, 0.8}), 0, 1e-9);
  }
}

TEST(SmoothStroke, KeepsACorner) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 50; ++i) points.push_back({2.0 * i, 0});
  for (int i = 1; i <= 50; ++i) points.push_back({100, 2.0 * i});
  auto const smooth = smoothed(samples_of(points));
  EXPECT_NEAR(distance(smooth[50].position, {100, 0}), 0, 0.01);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(distance(smooth[i].position, points[i]), 1.0);
  }
}

TEST(SmoothStroke, ACircleKeepsItsSize) {
  for (double const radius : {4.0, 10.0, 40.0}) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 120; ++i) {
      auto const at = sin_cos(2 * kPi * i / 120);
      points.push_back(Vec2{at.cos, at.sin} * radius);
    }
    for (auto const& sample : smoothed(samples_of(points))) {
      EXPECT_NEAR(norm(sample.position), radius, 0.08 * radius);
    }
  }
}

TEST(SmoothStroke, ZeroLeavesTheLineAsDrawn) {
  auto const raw = trembling_line();
  EXPECT_EQ(smoothed(raw, 0), raw);
}

TEST(SmoothStroke, KeepsPressureAndTime) {
  std::vector<Sample> const raw = {{{0, 0}, 0.2, 0}, {{1, 1}, 0.4, 0.1}, {{2, 0}, 0.6, 0.2}};
  auto const smooth = smoothed(raw);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    EXPECT_EQ(smooth[i].pressure, raw[i].pressure);
    EXPECT_EQ(smooth[i].time_s, raw[i].time_s);
  }
}

TEST(SmoothStroke, NastyLinesStayFinite) {
  std::vector<std::vector<Vec2>> const lines = {
      {},
      {{5, 5}},
      {{5, 5}, {5, 5}, {5, 5}},
      {{0, 0}, {10, 0}, {0, 0}, {10, 0}, {0, 0}},
      {{-1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}},
      {{0, 0}, {1e-300, 0}, {2e-300, 0}, {1e-12, 1e-12}, {1, 0}},
      {{1e6, 1e6}, {1e6, 1e6 - 1e-10}, {1e6 - 1e-10, 1e6}},
  };
  for (auto const& line : lines) {
    auto const smooth = smoothed(samples_of(line));
    EXPECT_EQ(smooth.size(), line.size());
    for (auto const& sample : smooth) {
      EXPECT_TRUE(is_finite(sample.position));
      EXPECT_LE(std::abs(sample.position.x), 1e6);
      EXPECT_LE(std::abs(sample.position.y), 1e6);
    }
  }
}

}  // namespace
}  // namespace inkflate
