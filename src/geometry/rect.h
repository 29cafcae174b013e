// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "geometry/vec2.h"

namespace inkflate {

/// An axis-parallel rectangle, px. Made empty (min > max); grows by include().
struct Rect {
  Vec2 min = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 max = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  friend bool operator==(Rect const&, Rect const&) = default;

  bool is_empty() const { return min.x > max.x; }
  double width() const { return is_empty() ? 0 : max.x - min.x; }
  double height() const { return is_empty() ? 0 : max.y - min.y; }
  double longer_side() const { return std::max(width(), height()); }
  Vec2 centre() const { return (min + max) / 2; }

  void include(Vec2 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
};

}  // namespace inkflate
