// SPDX-License-Identifier: Apache-2.0
#include "geometry/crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/rng.h"
#include "geometry/predicates.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

using Pair = std::array<int, 4>;

bool lies_on(Vec2 p, Vec2 a, Vec2 b) { return segments_touch(p, p, a, b); }

/// Neighbours may have their common corner and nothing else; all others nothing.
bool clash(Contour const& a, int i, Contour const& b, int j, bool is_same) {
  int const n = static_cast<int>(std::ssize(a));
  int const m = static_cast<int>(std::ssize(b));
  if (is_same && (i + 1) % n == j)
    return lies_on(a[(j + 1) % n], a[i], a[j]) || lies_on(a[i], a[j], a[(j + 1) % n]);
  if (is_same && (j + 1) % n == i) return clash(a, j, b, i, true);
  return segments_touch(a[i], a[(i + 1) % n], b[j], b[(j + 1) % m]);
}

std::vector<Pair> by_all_pairs(std::vector<Contour> const& contours) {
  std::vector<Pair> found;
  for (int a = 0; a < std::ssize(contours); ++a) {
    int const n = static_cast<int>(std::ssize(contours[a]));
    if (n < 3) found.push_back({a, 0, a, 0});
    for (int b = a; b < std::ssize(contours); ++b) {
      for (int i = 0; i < n; ++i) {
        for (int j = a == b ? i + 1 : 0; j < std::ssize(contours[b]); ++j) {
          if (clash(contours[a], i, contours[b], j, a == b)) found.push_back({a, i, b, j});
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Pair> by_library(std::vector<Contour> const& contours) {
  std::vector<Pair> found;
  for (auto const& c : find_crossings(contours, 1'000'000)) {
    Pair const forward = {c.contour_a, c.edge_a, c.contour_b, c.edge_b};
    Pair const back = {c.contour_b, c.edge_b, c.contour_a, c.edge_a};
    found.push_back(std::min(forward, back));
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Simple: one corner per direction, seen from the centre.
Contour star(Rng& rng, Vec2 centre, int corners) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    auto const [sine, cosine] = sin_cos(2 * kPi * i / corners);
    contour.push_back(centre + Vec2{cosine, sine} * rng.uniform(1, 40));
  }
  return contour;
}

TEST(Crossings, EqualAllPairsOnRandomContoursThatCoincide) {
  for (std::uint64_t seed = 0; seed < 250; ++seed) {
    Rng rng(seed);
    std::vector<Contour> contours(static_cast<std::size_t>(1 + rng.below(3)));
    int const lattice = 3 + rng.below(20);
    double const stretch = seed % 5 == 0 ? 1e6 : 1;
    for (auto& contour : contours) {
      contour.resize(static_cast<std::size_t>(rng.below(14)));
      for (auto& p : contour) p = {rng.below(lattice) * 0.1 * stretch, rng.below(lattice) * 0.1};
    }
    ASSERT_EQ(by_library(contours), by_all_pairs(contours)) << "seed " << seed;
  }
}

TEST(Crossings, EqualAllPairsWhenEdgesAreOfVeryUnlikeLength) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    Contour contour;
    Vec2 at;
    for (int i = 0; i < 80; ++i) {
      double const step = rng.below(10) == 0 ? 1000 : 0.01;
      at += Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)} * step;
      contour.push_back(at);
    }
    ASSERT_EQ(by_library({contour}), by_all_pairs({contour})) << "seed " << seed;
  }
}

TEST(Crossings, StarsAroundTheirCentreAreSimple) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Rng rng(seed);
    auto const contour = star(rng, {1e3, -1e3}, 5 + rng.below(60));
    EXPECT_TRUE(is_simple(contour)) << seed;
  }
}

TEST(Crossings, ASpiralIsSimpleUntilItsTurnsMeet) {
  for (double const width : {0.6, 1.0}) {
    Contour contour;
    int const steps = 200;
    for (int side = 0; side < 2; ++side) {
      for (int k = 0; k <= steps; ++k) {
        int const i = side == 0 ? k : steps - k;
        auto const [sine, cosine] = sin_cos(8 * kPi * i / steps);
        contour.push_back(Vec2{cosine, sine} * (2 + 4.0 * i / steps + side * width * 1.001));
      }
    }
    EXPECT_EQ(is_simple(contour), width < 1);
  }
}

TEST(Crossings, ATouchingCornerIsACrossing) {
  Contour const figure = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  EXPECT_FALSE(is_simple(figure));
  Contour const square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  Contour const beside = {{4, 4}, {9, 4}, {9, 9}};
  Contour const apart = {{5, 5}, {9, 5}, {9, 9}};
  Contour const within = {{1, 1}, {2, 1}, {2, 2}};
  EXPECT_EQ(find_crossings(std::vector<Contour>{square, beside}, 10).size(), 4U);
  EXPECT_TRUE(find_crossings(std::vector<Contour>{square, apart, within}, 10).empty());
}

TEST(Crossings, AFoldBackIsACrossingAStraightCornerIsNot) {
  EXPECT_TRUE(is_simple({{0, 0}, {2, 0}, {4, 0}, {4, 4}}));
  EXPECT_FALSE(is_simple({{0, 0}, {4, 0}, {2, 0}, {4, 4}}));
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {4, 0}}));
}

TEST(Crossings, FewerThanThreeCornersAndRepeatedPointsAreNotSimple) {
  EXPECT_FALSE(is_simple({}));
  EXPECT_FALSE(is_simple({{1, 1}}));
  EXPECT_FALSE(is_simple({{1, 1}, {2, 2}}));
  EXPECT_FALSE(is_simple({{1, 1}, {2, 2}, {2, 2}, {1, 3}}));
  EXPECT_TRUE(find_crossings({}, 10).empty());
}

TEST(Crossings, NoMoreAreGivenThanAskedFor) {
  Contour bow(40);
  for (int i = 0; i < 40; ++i) bow[i] = {i % 2 * 10.0, i * 0.1};
  std::vector<Contour> const contours = {{}, {{1, 1}}, bow, bow, {{5, 5}, {6, 6}}};
  for (int const most : {0, 1, 2, 10}) EXPECT_EQ(std::ssize(find_crossings(contours, most)), most);
}

}  // namespace
}  // namespace inkflate
