// SPDX-License-Identifier: Apache-2.0
#include "geometry/point_grid.h"

#include <gtest/gtest.h>

#include "base/rng.h"

namespace inkflate {
namespace {

std::vector<int> visits(PointGrid const& grid, std::size_t count, Vec2 p, double radius) {
  std::vector<int> times(count, 0);
  grid.near(p, radius, [&](int i) { ++times[i]; });
  return times;
}

TEST(PointGrid, VisitsEveryPointWithinTheRadiusOnce) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    std::vector<Vec2> points(static_cast<std::size_t>(1 + rng.below(80)));
    double const height = seed % 4 == 0 ? 0 : rng.uniform(0, 100);
    for (auto& p : points) {
      p = {rng.uniform(-50, 50), rng.uniform(0, 1) * height};
      if (seed % 3 == 0) p = {std::floor(p.x), std::floor(p.y)};
    }
    PointGrid const grid(points, rng.uniform(0.01, 30));
    for (int query = 0; query < 10; ++query) {
      Vec2 const p = {rng.uniform(-80, 80), rng.uniform(-40, 140)};
      double const radius = rng.below(4) == 0 ? 0 : rng.uniform(0, 40);
      auto const times = visits(grid, points.size(), query == 0 ? points[0] : p, radius);
      Vec2 const at = query == 0 ? points[0] : p;
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_LE(times[i], 1) << seed;
        if (distance(points[i], at) <= radius) {
          EXPECT_EQ(times[i], 1) << seed;
        }
      }
    }
  }
}

TEST(PointGrid, LeavesOutWhatIsFarOff) {
  std::vector<Vec2> points;
  for (int i = 0; i < 1000; ++i) points.push_back({i % 40 * 10.0, i / 40 * 10.0});
  PointGrid const grid(points, 20);
  int visited = 0;
  grid.near({200, 120}, 20, [&](int) { ++visited; });
  EXPECT_GE(visited, 13);         // the disc holds so many
  EXPECT_LE(visited, 6 * 6 + 6);  // three buckets by three, of two points by two
}

TEST(PointGrid, WithoutPointsVisitsNothing) {
  PointGrid const grid(std::vector<Vec2>{}, 5);
  grid.near({0, 0}, 1e3, [](int) { ADD_FAILURE(); });
}

TEST(PointGrid, PointsAtOnePlaceAreVisitedInOrder) {
  std::vector<Vec2> const points(5, Vec2{3, 3});
  std::vector<int> order;
  PointGrid(points, 1).near({3, 3}, 0, [&](int i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace inkflate
