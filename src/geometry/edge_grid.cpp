// SPDX-License-Identifier: Apache-2.0
#include "geometry/edge_grid.h"

#include <algorithm>
#include <cmath>

namespace inkflate {

EdgeGrid::EdgeGrid(std::span<Edge const> edges) : edges_(edges) {
  double total = 0;
  for (auto const& edge : edges) {
    box_.include(edge.from);
    box_.include(edge.to);
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

int EdgeGrid::cell(double offset) const { return static_cast<int>(std::floor(offset / side_)); }

EdgeGrid::Range EdgeGrid::range(double a, double b, double origin) const {
  return {cell(std::min(a, b) - origin), cell(std::max(a, b) - origin)};
}

/// The bucket of the top left corner of what two bounding boxes share: the one place where a pair is looked at.
int EdgeGrid::home(int a, int b) const {
  auto const& first = edges_[static_cast<std::size_t>(a)];
  auto const& second = edges_[static_cast<std::size_t>(b)];
  int const x = std::max(range(first.from.x, first.to.x, box_.min.x).low,
                         range(second.from.x, second.to.x, box_.min.x).low);
  int const y = std::max(range(first.from.y, first.to.y, box_.min.y).low,
                         range(second.from.y, second.to.y, box_.min.y).low);
  return y * columns_ + x;
}

template <typename Visit>
void EdgeGrid::for_buckets(Edge const& edge, Visit visit) const {
  auto const x = range(edge.from.x, edge.to.x, box_.min.x);
  auto const y = range(edge.from.y, edge.to.y, box_.min.y);
  for (int row = y.low; row <= y.high; ++row) {
    for (int column = x.low; column <= x.high; ++column) visit(row * columns_ + column);
  }
}

void EdgeGrid::fill() {
  int const count = columns_ * rows_;
  starts_.assign(static_cast<std::size_t>(count) + 1, 0);
  for (auto const& edge : edges_) for_buckets(edge, [&](int b) { ++starts_[b + 1]; });
  for (int b = 0; b < count; ++b) starts_[b + 1] += starts_[b];
  items_.resize(static_cast<std::size_t>(starts_.back()));
  auto next = starts_;
  for (int i = 0; i < std::ssize(edges_); ++i)
    for_buckets(edges_[static_cast<std::size_t>(i)], [&](int b) { items_[next[b]++] = i; });
}

}  // namespace inkflate
