// SPDX-License-Identifier: Apache-2.0
#include "geometry/crossings.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace inkflate {
namespace {

struct Edge {
  Vec2 from;
  Vec2 to;
  int contour;
  int index;
  int count;  // of the contour's edges
};

struct Range {
  int low;
  int high;
};

/// Square buckets; each edge stands in every bucket that its bounding box meets.
class EdgeGrid {
 public:
  explicit EdgeGrid(std::vector<Edge> const& edges) : edges_(edges) {
    double total = 0;
    for (auto const& edge : edges) {
      box_.include(edge.from);
      total += std::abs(edge.to.x - edge.from.x) + std::abs(edge.to.y - edge.from.y);
    }
    double const mean = total / static_cast<double>(edges.size());
    // Not more than about four buckets per edge, however unlike in length they are.
    double const least = std::sqrt((box_.width() + mean) * (box_.height() + mean) /
                                   (4.0 * static_cast<double>(edges.size())));
    side_ = std::max({mean, least, 1e-9});
    columns_ = cell(box_.max.x - box_.min.x) + 1;
    rows_ = cell(box_.max.y - box_.min.y) + 1;
    fill();
  }

  int bucket_count() const { return columns_ * rows_; }
  std::span<int const> bucket(int b) const {
    return std::span(items_).subspan(static_cast<std::size_t>(starts_[b]),
                                     static_cast<std::size_t>(starts_[b + 1] - starts_[b]));
  }

  /// The bucket of the top left corner of what two bounding boxes share: the one place where a pair is looked at.
  int home(Edge const& a, Edge const& b) const {
    int const x =
        std::max(range(a.from.x, a.to.x, box_.min.x).low, range(b.from.x, b.to.x, box_.min.x).low);
    int const y =
        std::max(range(a.from.y, a.to.y, box_.min.y).low, range(b.from.y, b.to.y, box_.min.y).low);
    return y * columns_ + x;
  }

 private:
  int cell(double offset) const { return static_cast<int>(std::floor(offset / side_)); }
  Range range(double a, double b, double origin) const {
    return {cell(std::min(a, b) - origin), cell(std::max(a, b) - origin)};
  }

  template <typename Visit>
  void for_buckets(Edge const& edge, Visit visit) const {
    auto const x = range(edge.from.x, edge.to.x, box_.min.x);
    auto const y = range(edge.from.y, edge.to.y, box_.min.y);
    for (int row = y.low; row <= y.high; ++row) {
      for (int column = x.low; column <= x.high; ++column) visit(row * columns_ + column);
    }
  }

  void fill() {
    starts_.assign(static_cast<std::size_t>(bucket_count()) + 1, 0);
    for (auto const& edge : edges_) for_buckets(edge, [&](int b) { ++starts_[b + 1]; });
    for (int b = 0; b < bucket_count(); ++b) starts_[b + 1] += starts_[b];
    items_.resize(static_cast<std::size_t>(starts_.back()));
    auto next = starts_;
    for (int i = 0; i < std::ssize(edges_); ++i)
      for_buckets(edges_[i], [&](int b) { items_[next[b]++] = i; });
  }

  std::vector<Edge> const& edges_;
  Rect box_;
  double side_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<int> starts_;
  std::vector<int> items_;
};

/// Whether c -> d folds back onto b -> c, its neighbour.
bool folds_back(Vec2 b, Vec2 c, Vec2 d) {
  return orientation_sign(b, c, d) == 0 && dot(c - b, d - c) <= 0;
}

bool clash(Edge const& a, Edge const& b) {
  if (a.contour == b.contour) {
    bool const a_then_b = (a.index + 1) % a.count == b.index;
    bool const b_then_a = (b.index + 1) % a.count == a.index;
    if (a_then_b && b_then_a) return true;  // two edges only
    if (a_then_b) return folds_back(a.from, a.to, b.to);
    if (b_then_a) return folds_back(b.from, b.to, a.to);
  }
  return segments_touch(a.from, a.to, b.from, b.to);
}

}  // namespace

std::vector<Crossing> find_crossings(std::span<Contour const> contours, int most) {
  std::vector<Crossing> found;
  std::vector<Edge> edges;
  for (int c = 0; c < std::ssize(contours); ++c) {
    auto const& points = contours[c];
    int const count = static_cast<int>(std::ssize(points));
    for (int i = 0; i < count; ++i)
      edges.push_back({points[i], points[(i + 1) % count], c, i, count});
    if (count < 3 && std::ssize(found) < most) found.push_back({c, 0, c, 0});
  }
  if (edges.empty()) return found;
  EdgeGrid const grid(edges);
  for (int b = 0; b < grid.bucket_count(); ++b) {
    auto const items = grid.bucket(b);
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t j = i + 1; j < items.size(); ++j) {
        auto const& first = edges[items[i]];
        auto const& second = edges[items[j]];
        if (!clash(first, second) || grid.home(first, second) != b) continue;
        if (std::ssize(found) >= most) return found;
        found.push_back({first.contour, first.index, second.contour, second.index});
      }
    }
  }
  return found;
}

bool is_simple(Contour const& contour) { return find_crossings(std::span(&contour, 1), 1).empty(); }

}  // namespace inkflate
