// SPDX-License-Identifier: Apache-2.0
#include "geometry/nonzero_boundary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rng.h"
#include "geometry/crossings.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr double kBridgePx = 1e-3;

/// Each edge is tagged with its place in the list.
TaggedContour tagged(Contour const& points) {
  TaggedContour contour = {points, {}};
  for (int i = 0; i < std::ssize(points); ++i) contour.tags.push_back(i);
  return contour;
}

std::vector<Contour> points_of(std::vector<TaggedContour> const& contours) {
  std::vector<Contour> points;
  for (auto const& contour : contours) points.push_back(contour.points);
  return points;
}

std::vector<TaggedContour> boundary_of(std::vector<Contour> const& contours,
                                       double bridge_px = kBridgePx) {
  std::vector<TaggedContour> input;
  for (auto const& contour : contours) input.push_back(tagged(contour));
  auto boundary = nonzero_boundary(input, bridge_px);
  EXPECT_TRUE(boundary.has_value());
  return boundary ? std::move(*boundary) : std::vector<TaggedContour>{};
}

double total_area(std::vector<TaggedContour> const& boundary) {
  double sum = 0;
  for (auto const& contour : boundary) sum += signed_area(contour.points);
  return sum;
}

double distance_to_edges(std::vector<Contour> const& contours, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      least = std::min(
          least, squared_distance_to_segment(p, contour[i], contour[(i + 1) % contour.size()]));
    }
  }
  return std::sqrt(least);
}

Contour square(double left, double top, double side) {
  return {{left, top}, {left + side, top}, {left + side, top + side}, {left, top + side}};
}

Contour reversed(Contour contour) {
  std::reverse(contour.begin(), contour.end());
  return contour;
}

TEST(NonzeroBoundary, ASimpleContourStaysTheSame) {
  auto const boundary = boundary_of({square(1, 2, 8)});
  ASSERT_EQ(boundary.size(), 1U);
  EXPECT_EQ(boundary[0].points, square(1, 2, 8));
  EXPECT_EQ(boundary[0].tags, (std::vector<int>{0, 1, 2, 3}));
}

TEST(NonzeroBoundary, AContourThatRunsBackwardsIsTurnedRound) {
  auto const boundary = boundary_of({reversed(square(0, 0, 8))});
  ASSERT_EQ(boundary.size(), 1U);
  EXPECT_EQ(signed_area(boundary[0].points), 64);
}

TEST(NonzeroBoundary, OverlappingSquaresAreOne) {
  auto const boundary = boundary_of({square(0, 0, 8), square(4, 4, 8)});
  ASSERT_EQ(boundary.size(), 1U);
  EXPECT_EQ(signed_area(boundary[0].points), 64 + 64 - 16);
}

TEST(NonzeroBoundary, SquaresSideBySideLoseTheSideBetween) {
  auto const boundary = boundary_of({square(0, 0, 8), square(8, 2, 4)});
  ASSERT_EQ(boundary.size(), 1U);
  EXPECT_EQ(signed_area(boundary[0].points), 64 + 16);
}

TEST(NonzeroBoundary, AHoleStaysAHole) {
  auto const boundary = boundary_of({square(0, 0, 8), reversed(square(2, 2, 4))});
  ASSERT_EQ(boundary.size(), 2U);
  EXPECT_EQ(total_area(boundary), 64 - 16);
}

TEST(NonzeroBoundary, AnArmThatComesBackToTheBodyEnclosesAHole) {
  // A bent arm: up from the square, to the right and down into it again.
  Contour const bent = {{0, 0},   {2, 0},  {2, -6}, {12, -6}, {12, 4},  {10, 4},
                        {10, -4}, {4, -4}, {4, 0},  {20, 0},  {20, 10}, {0, 10}};
  auto const boundary = boundary_of({bent});
  ASSERT_EQ(boundary.size(), 2U);
  EXPECT_GT(signed_area(boundary[0].points), 0);
  EXPECT_EQ(signed_area(boundary[1].points), -24);  // 6 wide, 4 high
}

TEST(NonzeroBoundary, ALoopThatTurnsOverBelongsToTheArea) {
  Contour const eight = {{0, 0}, {4, 4}, {8, 0}, {8, 4}, {4, 0}, {0, 4}};
  auto const boundary = boundary_of({eight});
  ASSERT_EQ(boundary.size(), 1U);  // its halves are joined where they meet
  EXPECT_TRUE(contains(boundary[0].points, {1, 2}));
  EXPECT_TRUE(contains(boundary[0].points, {7, 2}));
}

TEST(NonzeroBoundary, PiecesThatTouchInACornerAreJoinedByABridge) {
  auto const boundary = boundary_of({square(0, 0, 8), square(8, 8, 8)}, 1);
  ASSERT_EQ(boundary.size(), 1U);
  EXPECT_TRUE(contains(boundary[0].points, {8.1, 7.9}));
  EXPECT_FALSE(contains(boundary[0].points, {9, 7}));
}

TEST(NonzeroBoundary, WhatEnclosesNothingHasNone) {
  EXPECT_TRUE(boundary_of({}).empty());
  EXPECT_TRUE(boundary_of({{}, {{1, 1}}, {{3, 3}, {3, 3}, {3, 3}}}).empty());
  EXPECT_TRUE(boundary_of({{{0, 0}, {8, 3}, {4, 1.5}}}).empty());
  EXPECT_TRUE(boundary_of({square(0, 0, 8), reversed(square(0, 0, 8))}).empty());
}

TEST(NonzeroBoundary, EdgesThatLieOnOneAnotherHaveTheLeastTag) {
  auto const boundary = nonzero_boundary(
      std::vector<TaggedContour>{{square(0, 0, 8), {5, 5, 5, 5}}, {square(0, 0, 8), {7, 3, 7, 3}}},
      kBridgePx);
  ASSERT_TRUE(boundary.has_value() && boundary->size() == 1);
  EXPECT_EQ(boundary->front().tags, (std::vector<int>{5, 3, 5, 3}));
}

/// All laws for contours of any kind.
void expect_boundary(std::vector<Contour> const& contours, Rng& rng, double size) {
  auto const boundary = boundary_of(contours, kBridgePx * size);
  auto const points = points_of(boundary);
  EXPECT_TRUE(find_crossings(points, 1).empty());
  for (int i = 0; i < 60; ++i) {
    Vec2 const p = {rng.uniform(-0.1, 1.1) * size, rng.uniform(-0.1, 1.1) * size};
    if (distance_to_edges(contours, p) < 2 * kBridgePx * size) continue;
    EXPECT_EQ(winding_number(points, p), winding_number(contours, p) != 0 ? 1 : 0);
  }
  if (contours.size() != 1) return;
  for (auto const& contour : boundary) {
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      auto const middle =
          lerp(contour.points[i], contour.points[(i + 1) % contour.points.size()], 0.5);
      auto const tag = static_cast<std::size_t>(contour.tags[i]);
      EXPECT_LE(squared_distance_to_segment(middle, contours[0][tag],
                                            contours[0][(tag + 1) % contours[0].size()]),
                kBridgePx * kBridgePx * size * size);
    }
  }
}

TEST(NonzeroBoundary, OfAnyPolygonsItIsSimpleAndHasTheirAreaAndTags) {
  Rng rng(1);
  for (int i = 0; i < 400; ++i) {
    std::vector<Contour> contours(static_cast<std::size_t>(1 + rng.below(3)));
    double const size = std::ldexp(1, rng.below(24) - 4);
    for (auto& contour : contours) {
      int const count = 3 + rng.below(40);
      for (int k = 0; k < count; ++k)
        contour.push_back({rng.uniform(0, size), rng.uniform(0, size)});
    }
    expect_boundary(contours, rng, size);
  }
}

TEST(NonzeroBoundary, SoItIsWherePointsCoincideAndEdgesLieOnOneAnother) {
  Rng rng(2);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Contour> contours(static_cast<std::size_t>(1 + rng.below(3)));
    int const side = 2 + rng.below(7);
    for (auto& contour : contours) {
      int const count = 3 + rng.below(30);
      for (int k = 0; k < count; ++k)
        contour.push_back(
            {static_cast<double>(rng.below(side)), static_cast<double>(rng.below(side))});
    }
    expect_boundary(contours, rng, side - 1);
  }
}

TEST(NonzeroBoundary, SoItIsForSmoothLinesThatWindOverThemselves) {
  Rng rng(3);
  for (int i = 0; i < 60; ++i) {
    Contour contour;
    double const loops = 1 + rng.below(4);
    double const wave = 2 + rng.below(7);
    for (int k = 0; k < 600; ++k) {
      double const angle_rad = 2 * kPi * k / 600;
      auto const turn = sin_cos(angle_rad * loops);
      double const radius = 300 + 190 * sin_cos(angle_rad * wave).cos;
      contour.push_back(Vec2{500, 500} + Vec2{turn.cos, turn.sin} * radius);
    }
    expect_boundary({contour}, rng, 1000);
  }
}

TEST(NonzeroBoundary, FarFromTheOriginItIsTheSame) {
  Vec2 const far = {900'000, -900'000};
  auto contours = std::vector<Contour>{square(0, 0, 8), square(4, 4, 8)};
  auto const here = boundary_of(contours);
  for (auto& contour : contours) {
    for (auto& p : contour) p += far;
  }
  auto const there = boundary_of(contours);
  ASSERT_EQ(there.size(), here.size());
  EXPECT_EQ(total_area(there), total_area(here));
}

}  // namespace
}  // namespace inkflate
