// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec2.h"

namespace inkflate {

/// Decimal places on which moved points lie: 12.345 instead of 12.345028719340021. Nobody sees the difference, and a text is half as long.
class PlaceGrid {
 public:
  /// Of no grid: points are where they are.
  PlaceGrid() = default;
  /// For a shape of this longer side: 0.001 px, or so many decimals more that it is no more than 1e-5 of the shape; at most 9.
  static PlaceGrid of_shape(double longer_side_px);

  /// A point that was moved: on the grid; where it was if it has moved by less than half of the grid's width in x and y.
  Vec2 operator()(Vec2 rest, Vec2 moved) const;

 private:
  double per_px_ = 0;  // 0: no grid
};

}  // namespace inkflate
