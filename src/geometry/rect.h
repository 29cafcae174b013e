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
  /// Larger on every side; one that is empty stays so.
  Rect grown(double margin) const {
    return is_empty() ? *this : Rect{min - Vec2{margin, margin}, max + Vec2{margin, margin}};
  }
};

/// The smallest that holds both.
inline Rect united(Rect const& a, Rect const& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

inline bool contains(Rect const& rect, Vec2 p) {
  return rect.min.x <= p.x && p.x <= rect.max.x && rect.min.y <= p.y && p.y <= rect.max.y;
}

/// Whether they have a point in common; an empty one has none.
inline bool touch(Rect const& a, Rect const& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

}  // namespace inkflate
