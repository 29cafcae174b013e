// SPDX-License-Identifier: Apache-2.0
#include "geometry/polyline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rng.h"
#include "geometry/predicates.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

Contour const kL = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};

Contour regular(int corners, Vec2 centre, double radius) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    auto const [sine, cosine] = sin_cos(2 * kPi * i / corners);
    contour.push_back(centre + Vec2{cosine, sine} * radius);
  }
  return contour;
}

TEST(Polyline, LengthIsOpenAndPerimeterClosed) {
  EXPECT_DOUBLE_EQ(length(kL), 11);
  EXPECT_DOUBLE_EQ(perimeter(kL), 14);
  EXPECT_EQ(length(Polyline{}), 0);
  EXPECT_EQ(perimeter(Contour{}), 0);
  EXPECT_EQ(perimeter(Contour{{3, 3}}), 0);
  EXPECT_DOUBLE_EQ(perimeter(Contour{{0, 0}, {3, 4}}), 10);
}

TEST(Polyline, AreaIsPositiveClockwiseOnTheScreen) {
  EXPECT_DOUBLE_EQ(signed_area(kL), 6);
  auto turned = kL;
  std::reverse(turned.begin(), turned.end());
  EXPECT_DOUBLE_EQ(signed_area(turned), -6);
  EXPECT_EQ(signed_area(Contour{}), 0);
  EXPECT_EQ(signed_area(Contour{{0, 0}, {5, 5}}), 0);
}

TEST(Polyline, AreaOfARegularPolygonIsExactFarFromTheOrigin) {
  // n/2 r^2 sin(2 pi / n).
  double const expected = 6 * sin_cos(kPi / 6).sin;
  EXPECT_NEAR(signed_area(regular(12, {0, 0}, 1)), expected, 1e-14);
  EXPECT_NEAR(signed_area(regular(12, {1048576, -1048576}, 1)), expected, 1e-8);
}

TEST(Polyline, BoundsHoldExactlyThePoints) {
  EXPECT_EQ(bounds(kL), (Rect{{0, 0}, {4, 3}}));
  EXPECT_TRUE(bounds(Polyline{}).is_empty());
}

TEST(Polyline, ContainsIsTrueOnlyInsideOfAnL) {
  for (Vec2 const p : {Vec2{0.5, 0.5}, {3.5, 0.5}, {0.5, 2.5}, {0.99, 1.01}})
    EXPECT_TRUE(contains(kL, p)) << p.x << " " << p.y;
  for (Vec2 const p : {Vec2{1.5, 1.5}, {5, 0.5}, {-1, 0.5}, {0.5, 3.5}, {0.5, -1}, {3, 3}})
    EXPECT_FALSE(contains(kL, p)) << p.x << " " << p.y;
  EXPECT_FALSE(contains(Contour{}, {0, 0}));
}

TEST(Polyline, ContainsAgreesWithTheSidesOfAConvexPolygon) {
  Rng rng(4);
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    auto const contour = regular(3 + rng.below(9), {5, 5}, 4);
    Vec2 const p = {rng.uniform(0, 10), rng.uniform(0, 10)};
    bool is_right_of_all = true;
    for (std::size_t k = 0; k < contour.size(); ++k)
      is_right_of_all &= orientation_sign(contour[k], contour[(k + 1) % contour.size()], p) > 0;
    EXPECT_EQ(contains(contour, p), is_right_of_all);
    inside += is_right_of_all ? 1 : 0;
  }
  EXPECT_GT(inside, 30);
}

TEST(Polyline, ARayThroughCornersCountsThemOnce) {
  Contour const diamond = {{0, -2}, {2, 0}, {0, 2}, {-2, 0}};
  EXPECT_TRUE(contains(diamond, {0, 0}));
  EXPECT_FALSE(contains(diamond, {-3, 0}));
  EXPECT_FALSE(contains(diamond, {-3, -2}));
  EXPECT_FALSE(contains(diamond, {-3, 2}));
}

TEST(Polyline, TheWindingNumberTellsHowOftenAndWhichWay) {
  Contour const twice = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {6, 0}, {6, 6}, {0, 6}};
  EXPECT_EQ(winding_number(twice, {3, 3}), 2);
  EXPECT_EQ(winding_number(twice, {7, 7}), 1);
  EXPECT_EQ(winding_number(twice, {9, 3}), 0);
  EXPECT_EQ(winding_number(Contour(twice.rbegin(), twice.rend()), {3, 3}), -2);
}

TEST(Polyline, WindingNumbersOfSeveralContoursAddUp) {
  Contour const outer = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  Contour const hole = {{2, 2}, {2, 6}, {6, 6}, {6, 2}};
  std::vector<Contour> const ring = {outer, hole};
  EXPECT_EQ(winding_number(ring, {1, 1}), 1);
  EXPECT_EQ(winding_number(ring, {4, 4}), 0);
  EXPECT_TRUE(contains(ring, {1, 1}));
  EXPECT_FALSE(contains(ring, {4, 4}));
  EXPECT_FALSE(contains(ring, {9, 4}));
}

TEST(Polyline, WhatLiesUnderItselfIsInside) {
  Contour const twice = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {6, 0}, {6, 6}, {0, 6}};
  EXPECT_TRUE(contains(twice, {3, 3}));
}

TEST(Polyline, DistanceToASegmentIsTheLeastOverItsPoints) {
  Rng rng(2);
  for (int i = 0; i < 200; ++i) {
    Vec2 const a = {rng.uniform(-5, 5), rng.uniform(-5, 5)};
    Vec2 const b = {rng.uniform(-5, 5), rng.uniform(-5, 5)};
    Vec2 const p = {rng.uniform(-5, 5), rng.uniform(-5, 5)};
    double least = squared_norm(p - b);
    for (int k = 0; k < 200; ++k) least = std::min(least, squared_norm(p - lerp(a, b, k / 200.0)));
    double const found = squared_distance_to_segment(p, a, b);
    EXPECT_LE(found, least + 1e-12);
    EXPECT_GE(found, least - 0.3 * norm(b - a) / 200 * norm(b - a) - 1e-12);
  }
  EXPECT_EQ(squared_distance_to_segment({3, 4}, {0, 0}, {0, 0}), 25);
}

}  // namespace
}  // namespace inkflate
