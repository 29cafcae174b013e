// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/check.h"
#include "image/colour.h"

namespace inkflate {

/// A picture of values, row by row from the top; pixel (x, y) covers [x, x+1) x [y, y+1).
template <typename T>
struct Grid2 {
  int width = 0;
  int height = 0;
  std::vector<T> values;

  Grid2() = default;
  /// Both sides >= 0; the caller has checked them against the limits.
  Grid2(int w, int h, T value = {})
      : width(w),
        height(h),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}

  friend bool operator==(Grid2 const&, Grid2 const&) = default;

  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  T& at(int x, int y) {
    DCHECK(contains(x, y), "pixel outside the picture");
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  T const& at(int x, int y) const {
    DCHECK(contains(x, y), "pixel outside the picture");
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

using Mask = Grid2<std::uint8_t>;  // 0 outside, 255 inside
using Picture = Grid2<Colour>;

}  // namespace inkflate
