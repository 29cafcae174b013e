// SPDX-License-Identifier: Apache-2.0
#include "mesh/rim_spacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/rng.h"
#include "support/regions.h"

namespace inkflate {
namespace {

double least_of(std::vector<double> const& values) {
  return *std::min_element(values.begin(), values.end());
}
double most_of(std::vector<double> const& values) {
  return *std::max_element(values.begin(), values.end());
}

Contour rectangle(double width, double height) {
  return subdivided({{0, 0}, {width, 0}, {width, height}, {0, height}}, 1);
}

std::vector<double> spacing_of(Contour const& contour, RimSpacingOptions const& options = {}) {
  return rim_spacing(std::span(&contour, 1), options)[0];
}

constexpr RimSpacingOptions kWide = {.longest_px = 1000, .shortest_px = 0.01};

TEST(RimSpacing, OfADiscIsItsDiameterTimesTheShare) {
  auto const spacing = rim_spacing(disc_region(50, 1).contours, kWide);
  EXPECT_NEAR(least_of(spacing[0]), 10, 0.1);
  EXPECT_NEAR(most_of(spacing[0]), 10, 0.1);
}

TEST(RimSpacing, OfARingIsItsWidthTimesTheShareOnBothSides) {
  auto const spacing = rim_spacing(annulus_region(100, 80, 1).contours, kWide);
  for (auto const& values : spacing) {
    EXPECT_NEAR(least_of(values), 2, 0.05);
    EXPECT_NEAR(most_of(values), 2, 0.05);
  }
}

TEST(RimSpacing, StaysWithinItsLimits) {
  auto const spacing =
      rim_spacing(comb_region(3, 3, 1).contours, {.longest_px = 3, .shortest_px = 2});
  EXPECT_EQ(least_of(spacing[0]), 2);
  EXPECT_EQ(most_of(spacing[0]), 3);
}

TEST(RimSpacing, IsHalfOfTheNeighboursInASquareCorner) {
  auto const spacing = spacing_of(rectangle(100, 100), kWide);
  EXPECT_NEAR(most_of(spacing), 10, 0.1);
  EXPECT_NEAR(spacing[0], 5, 0.2);
}

TEST(RimSpacing, OfAWedgeFallsTowardsItsTip) {
  // 10 px wide after 100: a circle that touches both sides at distance s from the tip is about s / 10 wide.
  Contour const corners = {{0, 0}, {200, -10}, {200, 10}};
  auto const contour = subdivided(corners, 0.5);
  auto const spacing = spacing_of(contour, {.longest_px = 1000, .shortest_px = 1e-3});
  for (std::size_t i = 20; i < 300; i += 40) {
    double const from_tip = distance(contour[i], corners[0]);
    EXPECT_NEAR(spacing[i], 0.1 * from_tip * 0.1, 0.03) << from_tip;
  }
}

TEST(RimSpacing, NoiseOnTheContourDoesNotMatter) {
  Rng rng(1);
  auto contour = disc_region(50, 1).contours[0];
  for (auto& p : contour) p += Vec2{rng.uniform(-0.15, 0.15), rng.uniform(-0.15, 0.15)};
  auto const spacing = spacing_of(contour, kWide);
  EXPECT_GT(least_of(spacing), 8);
  EXPECT_LT(most_of(spacing), 10.5);
}

TEST(RimSpacing, GrowsNoFasterThanWanted) {
  // A thin arm on a wide body, and a thin place across which the other side is near.
  auto const region = comb_region(2, 4, 0.7);
  RimSpacingOptions const options = {.longest_px = 50, .shortest_px = 0.1, .growth = 0.2};
  auto const spacing = rim_spacing(region.contours, options)[0];
  auto const& contour = region.contours[0];
  auto const count = contour.size();
  for (std::size_t i = 0; i < count; ++i) {
    double const step = distance(contour[i], contour[(i + 1) % count]);
    EXPECT_LE(std::abs(spacing[i] - spacing[(i + 1) % count]), 0.2 * step + 1e-9);
  }
}

TEST(RimSpacing, IsFineAcrossFromAFinePlace) {
  // The upper side has a notch whose tip comes near the lower side.
  Contour const corners = {{0, 0}, {195, 0}, {200, 97}, {205, 0}, {400, 0}, {400, 100}, {0, 100}};
  auto const contour = subdivided(corners, 1);
  auto const spacing = spacing_of(contour, {.longest_px = 50, .shortest_px = 0.1});
  for (std::size_t i = 0; i < contour.size(); ++i) {
    if (contour[i].y < 100) continue;
    if (std::abs(contour[i].x - 200) < 2) {
      EXPECT_LT(spacing[i], 2);
    }
    if (std::abs(contour[i].x - 60) < 2) {
      EXPECT_GT(spacing[i], 6);
    }
  }
}

TEST(RimSpacing, OfContoursThatCrossIsTheLongest) {
  std::vector<Contour> const bow = {{{0, 0}, {10, 10}, {10, 0}, {0, 10}}};
  EXPECT_EQ(rim_spacing(bow)[0], std::vector<double>(4, RimSpacingOptions{}.longest_px));
}

TEST(Resample, PlacesAreWhereThePointsLie) {
  Polyline const line = {{0, 0}, {30, 0}, {30, 40}, {90, 40}};
  std::vector<double> const spacing(line.size(), 7);
  auto const points = resample(line, spacing);
  auto const places = resample_places(line, spacing);
  ASSERT_EQ(places.size(), points.size());
  EXPECT_EQ(places.front().edge, 0);
  EXPECT_EQ(places.back().edge, 3);
  EXPECT_EQ(places.back().share, 0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    auto const& [edge, share] = places[k];
    EXPECT_EQ(points[k], share > 0 ? lerp(line[edge], line[edge + 1], share) : line[edge]);
    EXPECT_TRUE(k == 0 || edge + share > places[k - 1].edge + places[k - 1].share);
  }
}

TEST(Resample, EvenSpacingGivesEvenPieces) {
  auto const line = resample(Polyline{{0, 0}, {3, 0}, {10, 0}}, std::vector<double>{2, 2, 2});
  ASSERT_EQ(line.size(), 6U);
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_NEAR(line[i].x, 2.0 * static_cast<double>(i), 1e-12);
}

TEST(Resample, FirstAndLastStayWhatTheyAre) {
  Polyline const line = {{0.1, 0.7}, {5, 5}, {7.3, 1.9}};
  for (double const spacing : {0.01, 1.0, 3.0, 100.0}) {
    auto const result = resample(line, std::vector<double>(3, spacing));
    EXPECT_GE(result.size(), 2U);
    EXPECT_EQ(result.front(), line.front());
    EXPECT_EQ(result.back(), line.back());
  }
}

TEST(Resample, PiecesAreAsLongAsWantedWhereTheyLie) {
  Polyline line;
  std::vector<double> spacing;
  for (int i = 0; i <= 100; ++i) {
    line.push_back({static_cast<double>(i), 0});
    spacing.push_back(1 + 0.04 * i);
  }
  auto const result = resample(line, spacing);
  for (std::size_t i = 1; i < result.size(); ++i) {
    double const wanted = 1 + 0.04 * (result[i - 1].x + result[i].x) / 2;
    EXPECT_NEAR(result[i].x - result[i - 1].x, wanted, 0.03 * wanted);
  }
}

TEST(Resample, AClosedLineKeepsAnArea) {
  auto const ring = ring_contour({0, 0}, 1, 40);
  auto closed = ring;
  closed.push_back(ring.front());
  auto const result = resample(closed, std::vector<double>(closed.size(), 1000));
  EXPECT_EQ(result.size(), 4U);
  EXPECT_EQ(result.front(), result.back());
  EXPECT_GT(std::abs(signed_area(result)), 1);
}

TEST(Resample, CornersStay) {
  auto const square = subdivided({{0, 0}, {50, 0}, {50, 50}, {0, 50}}, 2);
  auto closed = square;
  closed.push_back(square.front());
  auto const result = resample(closed, std::vector<double>(closed.size(), 7));
  for (auto const corner : {Vec2{50, 0}, Vec2{50, 50}, Vec2{0, 50}})
    EXPECT_EQ(std::count(result.begin(), result.end(), corner), 1);
  EXPECT_EQ(result.size(), 29U);
}

TEST(Resample, PointsAtOnePlaceAreNoTrouble) {
  auto const result = resample(Polyline(5, {3, 4}), std::vector<double>(5, 1));
  for (auto const p : result) EXPECT_EQ(p, (Vec2{3, 4}));
}

}  // namespace
}  // namespace inkflate
