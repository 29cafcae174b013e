// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/rect.h"
#include "geometry/vec2.h"

namespace inkflate {

/// A straight edge.
struct Edge {
  Vec2 from;
  Vec2 to;
};

/// Finds edges near one another: square buckets, each edge stands in every bucket that its bounding box meets.
class EdgeGrid {
 public:
  /// in      edges: at least one; finite; they outlive the grid
  /// cost    O(n) for edges of similar length
  explicit EdgeGrid(std::span<Edge const> edges);

  /// Calls take(i, j) for every pair of edges whose boxes share a bucket and of which meets(i, j) is true, each pair once, until take gives
  /// true; whether it did.
  template <typename Meets, typename Take>
  bool any_pair(Meets meets, Take take) const {
    for (int b = 0; b < columns_ * rows_; ++b) {
      for (int i = starts_[b]; i < starts_[b + 1]; ++i) {
        for (int j = i + 1; j < starts_[b + 1]; ++j) {
          if (!meets(items_[i], items_[j]) || home(items_[i], items_[j]) != b) continue;
          if (take(items_[i], items_[j])) return true;
        }
      }
    }
    return false;
  }

 private:
  struct Range {
    int low;
    int high;
  };

  int cell(double offset) const;
  Range range(double a, double b, double origin) const;
  int home(int a, int b) const;
  void fill();
  template <typename Visit>
  void for_buckets(Edge const& edge, Visit visit) const;

  std::span<Edge const> edges_;
  Rect box_;
  double side_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<int> starts_;
  std::vector<int> items_;
};

}  // namespace inkflate
