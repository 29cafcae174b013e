// SPDX-License-Identifier: Apache-2.0
#include "deform/line_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using support::bar_outline;
using support::disc_outline;
using support::polygon_outline;

Vec2 place_at(Outline const& outline, double parameter) {
  int const last = static_cast<int>(std::ssize(outline.pieces)) - 1;
  int const piece = std::min(last, static_cast<int>(parameter));
  return point_at(outline.pieces[piece].curve, parameter - piece);
}

TEST(SampleOutline, PutsPointsOnTheCurvesNoFartherApartThanWanted) {
  auto const disc = disc_outline({300, 200}, 100);
  for (double const step_px : {3.0, 40.0, 1000.0}) {
    auto const samples = sample_outline(disc, step_px);
    ASSERT_EQ(samples.points.size(), samples.parameters.size());
    ASSERT_GE(samples.points.size(), 4U);
    EXPECT_TRUE(samples.is_closed);
    EXPECT_TRUE(std::is_sorted(samples.parameters.begin(), samples.parameters.end()));
    for (std::size_t k = 0; k < samples.points.size(); ++k) {
      Vec2 const next = samples.points[(k + 1) % samples.points.size()];
      EXPECT_LT(distance(samples.points[k], place_at(disc, samples.parameters[k])), 1e-9);
      EXPECT_LE(distance(samples.points[k], next), step_px);
      // The middle of a chord is where it leaves a circle farthest; four cubics are a circle to 0.03 px of 100.
      double const off_px = 100 - distance(lerp(samples.points[k], next, 0.5), {300, 200});
      EXPECT_LE(off_px, 0.01 * step_px + 0.03);
    }
  }
}

TEST(SampleOutline, LeavesOutPointsThatCoincideWithTheOneBefore) {
  auto const square =
      polygon_outline({{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}, {10, 10}, {0, 10}, {0, 0}});
  auto const samples = sample_outline(square, 100);
  EXPECT_EQ(samples.points, (Polyline{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
  EXPECT_EQ(sample_outline(polygon_outline({{7, 7}, {7, 7}}), 1).points.size(), 1U);
  EXPECT_TRUE(sample_outline({}, 1).points.empty());
}

TEST(SampleLine, KeepsThePointsButThoseThatStandStill) {
  auto const samples = sample_line({{0, 0}, {5, 0}, {5, 0}, {5, 5}, {0, 0}});
  EXPECT_EQ(samples.points, (Polyline{{0, 0}, {5, 0}, {5, 5}, {0, 0}}));
  EXPECT_EQ(samples.parameters, (std::vector<double>{0, 1, 3, 4}));
  EXPECT_FALSE(samples.is_closed);
}

TEST(Thinned, HasFewerPointsOfTheSameLineAndItsCorners) {
  auto const bar = bar_outline(400, 40);
  auto const fine = sample_outline(bar, 1);
  auto const thin = thinned(fine, std::vector<double>(fine.points.size(), 10.0));
  EXPECT_NEAR(static_cast<double>(thin.points.size()), 88, 4);
  EXPECT_TRUE(std::is_sorted(thin.parameters.begin(), thin.parameters.end()));
  EXPECT_LT(thin.parameters.back(), 4);
  for (std::size_t k = 0; k < thin.points.size(); ++k) {
    // Straight sides, passed through evenly: a parameter tells its place exactly.
    EXPECT_LT(distance(thin.points[k], place_at(bar, thin.parameters[k])), 1e-9);
    Vec2 const next = thin.points[(k + 1) % thin.points.size()];
    EXPECT_NEAR(distance(thin.points[k], next), 10, 2.5);
  }
  for (Vec2 const corner : {Vec2{0, 0}, Vec2{400, 0}, Vec2{400, 40}, Vec2{0, 40}})
    EXPECT_NE(std::find(thin.points.begin(), thin.points.end(), corner), thin.points.end());
}

TEST(PutOnto, BringsThePointsOfChordsToTheCurves) {
  auto const disc = disc_outline({0, 0}, 100);
  auto const coarse = sample_outline(disc, 50);
  auto samples = thinned(coarse, std::vector<double>(coarse.points.size(), 17.0));
  auto const off_px = [&] {
    double most = 0;
    for (Vec2 const p : samples.points) most = std::max(most, std::abs(norm(p) - 100));
    return most;
  };
  EXPECT_GT(off_px(), 0.1);
  put_onto(disc, samples);
  EXPECT_LT(off_px(), 0.03);
}

}  // namespace
}  // namespace inkflate
