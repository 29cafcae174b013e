// SPDX-License-Identifier: Apache-2.0
#include "geometry/largest_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inkflate {
namespace {

constexpr int kNone = -1;

struct Wall {
  Vec2 low;
  Vec2 high;
  int contour = 0;
};

/// All edges by the rows of a lattice that they come into.
class Rows {
 public:
  explicit Rows(std::vector<TaggedContour> const& contours) {
    std::vector<Wall> walls;
    for (int c = 0; c < std::ssize(contours); ++c) {
      auto const& points = contours[static_cast<std::size_t>(c)].points;
      box_ = united(box_, bounds(points));
      for (std::size_t i = 0; i < points.size(); ++i) {
        auto const a = points[i];
        auto const b = points[(i + 1) % points.size()];
        if (a.y != b.y) walls.push_back(a.y < b.y ? Wall{a, b, c} : Wall{b, a, c});
      }
    }
    rows_.resize(static_cast<std::size_t>(2 * std::sqrt(static_cast<double>(walls.size()))) + 1);
    for (auto const& wall : walls) {
      for (std::size_t r = row(wall.low.y); r <= row(wall.high.y); ++r) rows_[r].push_back(wall);
    }
  }

  /// The contour that comes first on the way from a place to the left; none on the way out.
  int left_of(Vec2 p) const {
    int nearest = kNone;
    double nearest_x = -std::numeric_limits<double>::infinity();
    for (auto const& wall : rows_[row(p.y)]) {
      if (wall.low.y > p.y || wall.high.y <= p.y) continue;
      double const share = (p.y - wall.low.y) / (wall.high.y - wall.low.y);
      double const x = wall.low.x + share * (wall.high.x - wall.low.x);
      if (x >= p.x || x <= nearest_x) continue;
      nearest = wall.contour;
      nearest_x = x;
    }
    return nearest;
  }

 private:
  std::size_t row(double y) const {
    double const share = (y - box_.min.y) / box_.height();
    auto const count = static_cast<double>(rows_.size());
    return static_cast<std::size_t>(std::clamp(std::floor(share * count), 0.0, count - 1));
  }

  Rect box_;
  std::vector<std::vector<Wall>> rows_;
};

bool is_left_of(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

}  // namespace

std::vector<TaggedContour> largest_piece(std::vector<TaggedContour> const& boundary) {
  if (boundary.empty()) return {};
  std::size_t const count = boundary.size();
  std::vector<double> areas;
  std::vector<Vec2> leftmost;
  std::vector<int> order;
  for (std::size_t i = 0; i < count; ++i) {
    auto const& points = boundary[i].points;
    areas.push_back(signed_area(points));
    leftmost.push_back(*std::min_element(points.begin(), points.end(), is_left_of));
    order.push_back(static_cast<int>(i));
  }
  int const largest =
      static_cast<int>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  if (areas[largest] <= 0) return {};
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return is_left_of(leftmost[a], leftmost[b]); });
  Rows const rows(boundary);
  // What lies left of a hole is the contour around it or another hole in that; which has come before.
  std::vector<int> outer(count, kNone);
  std::vector<TaggedContour> piece = {boundary[largest]};
  for (int const i : order) {
    outer[i] = i;
    if (areas[i] > 0) continue;
    int const neighbour = rows.left_of(leftmost[i]);
    outer[i] = neighbour == kNone ? kNone : outer[neighbour];
    if (outer[i] == largest) piece.push_back(boundary[i]);
  }
  return piece;
}

}  // namespace inkflate
