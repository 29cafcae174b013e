// SPDX-License-Identifier: Apache-2.0
#include "geometry/crossings.h"

#include "geometry/edge_grid.h"
#include "geometry/predicates.h"

namespace inkflate {
namespace {

/// Which edge of which contour one is.
struct Place {
  int contour;
  int index;
  int count;  // of the contour's edges
};

/// Whether c -> d folds back onto b -> c, its neighbour.
bool folds_back(Vec2 b, Vec2 c, Vec2 d) {
  return orientation_sign(b, c, d) == 0 && dot(c - b, d - c) <= 0;
}

bool clash(Edge const& a, Place const& at_a, Edge const& b, Place const& at_b) {
  if (at_a.contour == at_b.contour) {
    bool const a_then_b = (at_a.index + 1) % at_a.count == at_b.index;
    bool const b_then_a = (at_b.index + 1) % at_a.count == at_a.index;
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
  std::vector<Place> places;
  for (int c = 0; c < std::ssize(contours); ++c) {
    auto const& points = contours[c];
    int const count = static_cast<int>(std::ssize(points));
    for (int i = 0; i < count; ++i) {
      edges.push_back({points[i], points[(i + 1) % count]});
      places.push_back({c, i, count});
    }
    if (count < 3 && std::ssize(found) < most) found.push_back({c, 0, c, 0});
  }
  if (edges.empty()) return found;
  EdgeGrid const grid(edges);
  grid.any_pair(
      [&](int i, int j) { return clash(edges[i], places[i], edges[j], places[j]); },
      [&](int i, int j) {
        if (std::ssize(found) >= most) return true;
        found.push_back({places[i].contour, places[i].index, places[j].contour, places[j].index});
        return false;
      });
  return found;
}

bool is_simple(Contour const& contour) { return find_crossings(std::span(&contour, 1), 1).empty(); }

}  // namespace inkflate
