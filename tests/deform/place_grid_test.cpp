// SPDX-License-Identifier: Apache-2.0
#include "deform/place_grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace inkflate {
namespace {

TEST(PlaceGrid, WhatHasMovedLiesOnTheNearestDecimals) {
  auto const grid = PlaceGrid::of_shape(300);
  EXPECT_EQ(grid({0, 0}, {12.34567, -7.00049}), (Vec2{12.346, -7}));
  EXPECT_EQ(grid({0, 0}, {999'999.98765, 1e6}), (Vec2{999'999.988, 1e6}));
  EXPECT_FALSE(std::signbit(grid({5, 5}, {-0.0001, 3}).x));
}

TEST(PlaceGrid, WhatHasHardlyMovedIsWhereItWasToTheLastBit) {
  auto const grid = PlaceGrid::of_shape(300);
  Vec2 const rest = {1.0 / 3, 200.0 / 7};
  EXPECT_EQ(grid(rest, rest), rest);
  EXPECT_EQ(grid(rest, rest + Vec2{4e-4, -4e-4}), rest);
  EXPECT_EQ(grid(rest, rest + Vec2{0, 2e-3}), (Vec2{0.333, 28.573}));
}

TEST(PlaceGrid, IsTheFinerTheSmallerTheShape) {
  Vec2 const moved = {1.23456789012, 2};
  EXPECT_EQ(PlaceGrid::of_shape(100)({}, moved).x, 1.235);
  EXPECT_EQ(PlaceGrid::of_shape(20)({}, moved).x, 1.2346);
  EXPECT_EQ(PlaceGrid::of_shape(0.1)({}, moved).x, 1.234568);
  EXPECT_EQ(PlaceGrid::of_shape(0)({}, moved).x, 1.23456789);
}

TEST(PlaceGrid, NoneLeavesAllWhereItIs) {
  EXPECT_EQ(PlaceGrid()({0, 0}, {1.0 / 3, 1e-12}), (Vec2{1.0 / 3, 1e-12}));
}

}  // namespace
}  // namespace inkflate
