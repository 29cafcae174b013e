// SPDX-License-Identifier: Apache-2.0
#include "geometry/curve_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rng.h"
#include "geometry/polyline.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

double distance_to_curve(Vec2 p, Cubic const& curve) {
  std::vector<Vec2> chords = {curve.start()};
  flatten_into(curve, 1e-4, chords);
  double least = squared_norm(p - chords[0]);
  for (std::size_t i = 1; i < chords.size(); ++i)
    least = std::min(least, squared_distance_to_segment(p, chords[i - 1], chords[i]));
  return std::sqrt(least);
}

/// Every law of the header that holds for any input.
void expect_fit(std::vector<FittedCubic> const& fitted, std::vector<Vec2> const& points,
                double tolerance) {
  ASSERT_FALSE(fitted.empty());
  EXPECT_EQ(fitted.front().first, 0);
  EXPECT_EQ(fitted.back().last, std::ssize(points) - 1);
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    auto const& piece = fitted[k];
    EXPECT_EQ(piece.curve.start(), points[piece.first]);
    EXPECT_EQ(piece.curve.end(), points[piece.last]);
    EXPECT_LT(piece.first, piece.last);
    for (int i = piece.first; i <= piece.last; ++i)
      EXPECT_LE(distance_to_curve(points[i], piece.curve), tolerance + 1e-3);
    if (k == 0) continue;
    EXPECT_EQ(piece.first, fitted[k - 1].last);
    auto const before = derivative_at(fitted[k - 1].curve, 1);
    auto const after = derivative_at(piece.curve, 0);
    EXPECT_NEAR(cross(normalized(before), normalized(after)), 0, 1e-9);
    // A piece that ends where it starts may be a mere point, without a direction.
    bool const is_loop = piece.curve.start() == piece.curve.end() ||
                         fitted[k - 1].curve.start() == fitted[k - 1].curve.end();
    if (!is_loop) {
      EXPECT_GT(dot(before, after), 0);
    }
  }
}

std::vector<Vec2> points_on(Cubic const& curve, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) points.push_back(point_at(curve, i / (count - 1.0)));
  return points;
}

Cubic const kArch = {{Vec2{0, 0}, Vec2{10, 60}, Vec2{50, 80}, Vec2{90, 10}}};

Cubic random_arch(Rng& rng) {
  return {{Vec2{0, 0}, Vec2{rng.uniform(25, 40), rng.uniform(-25, 25)},
           Vec2{rng.uniform(60, 75), rng.uniform(-25, 25)}, Vec2{100, rng.uniform(-20, 20)}}};
}

TEST(CurveFit, PointsOfOneCubicGiveOneCubicBack) {
  // A fiftieth of its length: the few steps on the parameters do not find the very curve again.
  constexpr double tolerance = 2;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng(seed);
    auto const arch = random_arch(rng);
    auto const points = points_on(arch, 60);
    auto const start = normalized(derivative_at(arch, 0));
    auto const end = normalized(derivative_at(arch, 1));
    auto const fitted = fit_cubics(points, start, end, tolerance);
    EXPECT_EQ(fitted.size(), 1U) << seed;
    expect_fit(fitted, points, tolerance);
    auto const one = fit_one_cubic(points, tolerance);
    ASSERT_TRUE(one.has_value()) << seed;
    for (double const t : {0.1, 0.4, 0.8})
      EXPECT_LT(distance_to_curve(point_at(arch, t), *one), 1.2 * tolerance) << seed;
  }
}

TEST(CurveFit, TangentsAtTheEndsAreAsGiven) {
  auto const points = points_on(kArch, 30);
  auto const start = normalized({1, -2});
  auto const end = normalized({3, 1});
  for (double const tolerance : {0.2, 5.0}) {
    auto const fitted = fit_cubics(points, start, end, tolerance);
    EXPECT_LT(distance(normalized(derivative_at(fitted.front().curve, 0)), start), 1e-9);
    EXPECT_LT(distance(normalized(derivative_at(fitted.back().curve, 1)), end), 1e-9);
  }
}

TEST(CurveFit, RandomWalksAreFollowedWithinTolerance) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    std::vector<Vec2> points = {{0, 0}};
    Vec2 step = {2, 0};
    int const count = 2 + rng.below(80);
    for (int i = 1; i < count; ++i) {
      // Smooth, jittery, and on a lattice, where walks come back to where they were.
      double const wildness = seed % 3 == 0 ? 0.3 : 3;
      step = normalized(step + Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)} * wildness) * 2;
      if (seed % 3 == 2)
        step =
            rng.below(2) == 0 ? Vec2{2.0 * rng.below(2) - 1, 0} : Vec2{0, 2.0 * rng.below(2) - 1};
      points.push_back(points.back() + step);
    }
    double const tolerance = rng.uniform(0.05, 3);
    expect_fit(fit_cubics(points, {1, 0}, {0, 1}, tolerance), points, tolerance);
    if (auto const one = fit_one_cubic(points, tolerance)) {
      EXPECT_EQ(one->start(), points.front());
      EXPECT_EQ(one->end(), points.back());
      for (auto const p : points) EXPECT_LE(distance_to_curve(p, *one), tolerance + 1e-3);
    }
  }
}

TEST(CurveFit, ACircleNeedsFewPieces) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 400; ++i) {
    auto const [sine, cosine] = sin_cos(2 * kPi * i / 400);
    points.push_back({300 * cosine, 300 * sine});
  }
  points.back() = points.front();
  auto const fitted = fit_cubics(points, {0, 1}, {0, 1}, 0.2);
  expect_fit(fitted, points, 0.2);
  EXPECT_LE(fitted.size(), 12U);
  for (auto const& piece : fitted)
    EXPECT_NEAR(norm(point_at(piece.curve, 0.37)), 300, 0.3);  // between the points as well
}

TEST(CurveFit, TwoPointsAlongTheirTangentsGiveALine) {
  std::vector<Vec2> const points = {{0, 0}, {3, 0}};
  auto const fitted = fit_cubics(points, {1, 0}, {1, 0}, 0.1);
  ASSERT_EQ(fitted.size(), 1U);
  EXPECT_EQ(fitted[0].curve, line_cubic({0, 0}, {3, 0}));
}

TEST(CurveFit, FewerThanFourPointsOrACornerHaveNoSingleCubic) {
  EXPECT_FALSE(fit_one_cubic(std::vector<Vec2>{{0, 0}, {1, 0}, {2, 1}}, 10).has_value());
  std::vector<Vec2> zigzag;
  for (int i = 0; i < 40; ++i)
    zigzag.push_back({i * 1.0, i / 10 % 2 == 0 ? i % 10 * 5.0 : 50 - i % 10 * 5.0});
  EXPECT_FALSE(fit_one_cubic(zigzag, 0.5).has_value());
}

TEST(CurveFit, ALineThatComesBackToItsStartIsFitted) {
  std::vector<Vec2> const there_and_back = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}};
  expect_fit(fit_cubics(there_and_back, {1, 0}, {-1, 0}, 0.1), there_and_back, 0.1);
}

}  // namespace
}  // namespace inkflate
