// SPDX-License-Identifier: Apache-2.0
#include "mesh/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/rng.h"
#include "mesh/hilbert.h"

namespace inkflate {
namespace {

using Points = std::vector<LatticePoint>;

/// Twice the area of the convex hull (Andrew's monotone chain), as an independent account of what must be covered.
std::int64_t twice_hull_area(Points points) {
  std::sort(points.begin(), points.end(),
            [](auto a, auto b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  Points hull;
  for (int pass = 0; pass < 2; ++pass) {
    auto const base = hull.size();
    for (auto const p : points) {
      while (hull.size() >= base + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  std::int64_t twice = 0;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i)
    twice += orientation(hull[0], hull[i], hull[i + 1]);
  return twice;
}

/// Checks every law of the header; O(triangles * points).
void expect_delaunay(Points const& points, std::string const& what) {
  SCOPED_TRACE(what);
  auto const mesh = delaunay(points);
  std::int64_t twice_area = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    auto const a = points[mesh.corners[3 * t]];
    auto const b = points[mesh.corners[3 * t + 1]];
    auto const c = points[mesh.corners[3 * t + 2]];
    ASSERT_GT(orientation(a, b, c), 0);
    twice_area += orientation(a, b, c);
    for (auto const p : points) ASSERT_LE(in_circle(a, b, c, p), 0);
  }
  EXPECT_EQ(twice_area, twice_hull_area(points));
  for (int e = 0; e < std::ssize(mesh.twins); ++e) {
    if (mesh.twins[e] < 0) continue;
    EXPECT_EQ(mesh.twins[mesh.twins[e]], e);
    EXPECT_EQ(mesh.corners[mesh.twins[e]], mesh.corners[next_half_edge(e)]);
  }
  for (int i = 0; i < std::ssize(points); ++i) {
    EXPECT_EQ(points[mesh.same_as[i]], points[i]);
    EXPECT_LE(mesh.same_as[i], i);
    EXPECT_EQ(mesh.same_as[mesh.same_as[i]], mesh.same_as[i]);
  }
}

TEST(Delaunay, CirclesAreEmptyAndTheHullIsCoveredOnRandomPoints) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    int const size = seed % 3 == 0   ? 4
                     : seed % 3 == 1 ? 40
                                     : kLatticeSize;  // small sizes force coincidence
    Points points(static_cast<std::size_t>(rng.below(120)));
    for (auto& p : points) p = {rng.below(size + 1), rng.below(size + 1)};
    expect_delaunay(points, "seed " + std::to_string(seed));
  }
}

TEST(Delaunay, CocircularAndCollinearPointsAreNoSpecialCase) {
  Points lattice;
  for (int x = 0; x < 9; ++x) {
    for (int y = 0; y < 9; ++y) lattice.push_back({x * 7, y * 7});
  }
  expect_delaunay(lattice, "square lattice");
  Points circle;
  for (auto const& [x, y] : {std::pair{25, 0}, {24, 7}, {20, 15}, {15, 20}, {7, 24}}) {
    for (int const sx : {-1, 1}) {
      for (int const sy : {-1, 1}) {
        circle.push_back({100 + sx * x, 100 + sy * y});
        circle.push_back({100 + sx * y, 100 + sy * x});
      }
    }
  }
  expect_delaunay(circle, "points of one circle");
  Points cross;
  for (int i = 0; i <= 20; ++i) {
    cross.push_back({i * 5, 50});
    cross.push_back({50, i * 5});
  }
  expect_delaunay(cross, "cross");
  expect_delaunay(
      {{0, 0}, {kLatticeSize, kLatticeSize}, {0, kLatticeSize}, {kLatticeSize, 0}, {8192, 8191}},
      "corners");
}

TEST(Delaunay, PointsOfOneLineHaveNoTriangles) {
  Points line;
  for (int i = 0; i < 30; ++i) line.push_back({3 * i, 5 * i});
  EXPECT_EQ(delaunay(line).triangle_count(), 0);
  EXPECT_EQ(delaunay(Points{}).triangle_count(), 0);
  EXPECT_EQ(delaunay(Points{{4, 4}, {4, 4}}).triangle_count(), 0);
  line.push_back({0, 1});
  expect_delaunay(line, "line and one point beside it");
}

TEST(Delaunay, HilbertOrderStepsToANeighbour) {
  Points square;
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) square.push_back({x, y});
  }
  auto const order = hilbert_order(square);
  for (std::size_t i = 1; i < order.size(); ++i) {
    auto const a = square[order[i - 1]];
    auto const b = square[order[i]];
    EXPECT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1);
  }
}

}  // namespace
}  // namespace inkflate
