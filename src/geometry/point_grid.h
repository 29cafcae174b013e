// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "geometry/polyline.h"

namespace inkflate {

/// Finds points near a place: square buckets over the points' bounding box, the points of a bucket side by side.
class PointGrid {
 public:
  /// side_px: of a bucket, > 0; the radius that will be asked for most is a good choice. At most about 4 buckets per point are made.
  PointGrid(std::span<Vec2 const> points, double side_px) {
    auto const box = bounds(points);
    if (box.is_empty()) return;
    origin_ = box.min;
    double const most = 4.0 * static_cast<double>(points.size()) + 16;
    side_ = side_px;
    while ((box.width() / side_ + 1) * (box.height() / side_ + 1) > most) side_ *= 2;
    columns_ = static_cast<int>(box.width() / side_) + 1;
    rows_ = static_cast<int>(box.height() / side_) + 1;
    starts_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    for (auto const p : points) ++starts_[bucket(p) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    items_.resize(points.size());
    auto next = starts_;
    for (int i = 0; i < std::ssize(points); ++i) items_[next[bucket(points[i])]++] = i;
  }

  /// Calls visit(index) for at least every point within radius of p; those of a bucket in index order.
  template <typename Visit>
  void near(Vec2 p, double radius, Visit visit) const {
    any_near(p, radius, [&](int i) {
      visit(i);
      return false;
    });
  }

  /// The same until holds(index) is true for a point; whether it was for any.
  template <typename Holds>
  bool any_near(Vec2 p, double radius, Holds holds) const {
    int const x0 = std::max(0, column(p.x - radius));
    int const x1 = std::min(columns_ - 1, column(p.x + radius));
    int const y0 = std::max(0, row(p.y - radius));
    int const y1 = std::min(rows_ - 1, row(p.y + radius));
    for (int y = y0; y <= y1 && x0 <= x1; ++y) {
      // The buckets of a row stand side by side.
      int const end = starts_[y * columns_ + x1 + 1];
      for (int k = starts_[y * columns_ + x0]; k < end; ++k) {
        if (holds(items_[k])) return true;
      }
    }
    return false;
  }

 private:
  int column(double x) const { return static_cast<int>(std::floor((x - origin_.x) / side_)); }
  int row(double y) const { return static_cast<int>(std::floor((y - origin_.y) / side_)); }
  int bucket(Vec2 p) const {
    return std::min(row(p.y), rows_ - 1) * columns_ + std::min(column(p.x), columns_ - 1);
  }

  Vec2 origin_;
  double side_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<int> starts_;
  std::vector<int> items_;
};

}  // namespace inkflate
