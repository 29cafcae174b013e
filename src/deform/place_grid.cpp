// SPDX-License-Identifier: Apache-2.0
#include "deform/place_grid.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

constexpr double kPerPx = 1000;
// Doubles hold no finer decimals at 1e6 px.
constexpr double kMostPerPx = 1e9;
constexpr double kLeastPerShape = 1e5;

}  // namespace

PlaceGrid PlaceGrid::of_shape(double longer_side_px) {
  PlaceGrid grid;
  grid.per_px_ = kPerPx;
  while (grid.per_px_ < kMostPerPx && grid.per_px_ * longer_side_px < kLeastPerShape) {
    grid.per_px_ *= 10;
  }
  return grid;
}

Vec2 PlaceGrid::operator()(Vec2 rest, Vec2 moved) const {
  if (per_px_ == 0) return moved;
  Vec2 const way = moved - rest;
  if (std::max(std::abs(way.x), std::abs(way.y)) * per_px_ < 0.5) return rest;
  // The quotient of two whole numbers is the double that is nearest to the decimal. Adding 0 makes 0 of a negative zero.
  auto const nearest = [&](double value) { return std::round(value * per_px_) / per_px_ + 0.0; };
  return {nearest(moved.x), nearest(moved.y)};
}

}  // namespace inkflate
