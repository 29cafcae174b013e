// SPDX-License-Identifier: Apache-2.0
#include "simplify/fit_rims.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rng.h"
#include "geometry/crossings.h"
#include "geometry/trig.h"
#include "simplify/simplify.h"
#include "support/rims.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// Rims as fit_rims asks for them, with positions as far off as centring could ever take them.
std::vector<Outline> fitted(HandMadeRims const& made, double off_px, Rng& rng, double smooth) {
  std::vector<Contour> centred;
  for (int r = 0; r < std::ssize(made.rims); ++r) {
    centred.push_back(made.contour(r));
    for (auto& p : centred.back()) p += Vec2{rng.uniform(-1, 1), rng.uniform(-1, 1)} * off_px;
  }
  return fit_rims(made.rims, centred, made.samples, {}, smooth);
}

void expect_valid(std::vector<Outline> const& outlines, HandMadeRims const& made) {
  ASSERT_EQ(outlines.size(), made.rims.size());
  std::vector<Contour> polygons;
  for (auto const& outline : outlines) {
    auto const& pieces = outline.pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      EXPECT_EQ(pieces[i].curve.end(), pieces[(i + 1) % pieces.size()].curve.start());
    polygons.push_back(flatten(outline, 0.01));
  }
  EXPECT_TRUE(find_crossings(polygons, 10).empty());
}

bool is_usable(HandMadeRims const& made) {
  std::vector<Contour> contours;
  for (int r = 0; r < std::ssize(made.rims); ++r) contours.push_back(made.contour(r));
  return find_crossings(contours, 1).empty();
}

/// Tries several degrees of smoothness and of being off. Returns how often the rims were simple to begin with.
int expect_valid_whatever_the_positions(HandMadeRims const& made, std::uint64_t seed) {
  SCOPED_TRACE(seed);
  if (!is_usable(made)) return 0;
  Rng rng(seed);
  for (double const smooth : {0.0, 0.5, 1.0})
    expect_valid(fitted(made, rng.uniform(0, 6), rng, smooth), made);
  return 1;
}

TEST(FitRims, RandomStarsEndSimple) {
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    Rng rng(seed);
    Contour star;
    int const corners = 3 + rng.below(60);
    double const least = rng.uniform(2, 200);
    for (int i = 0; i < corners; ++i) {
      auto const [sine, cosine] = sin_cos(2 * kPi * i / corners);
      star.push_back(Vec2{512, 512} + Vec2{cosine, sine} * rng.uniform(least, 250));
    }
    HandMadeRims made;
    made.add(resampled(star, seed % 2 == 0 ? 2.2 : 1000));
    tried += expect_valid_whatever_the_positions(made, seed);
  }
  EXPECT_GT(tried, 15);
}

TEST(FitRims, NarrowCombsEndSimple) {
  for (double const width_px : {1.0, 3.0, 9.0}) {
    Contour comb;
    for (int i = 0; i < 12; ++i) {
      double const x = 100 + 2 * i * width_px;
      comb.insert(comb.end(), {{x, 500}, {x, 200}, {x + width_px, 200}, {x + width_px, 500}});
    }
    comb.insert(comb.end(), {{100 + 24 * width_px, 520}, {100, 520}});
    HandMadeRims made;
    made.add(resampled(comb));
    EXPECT_EQ(expect_valid_whatever_the_positions(made, 1), 1);
  }
}

TEST(FitRims, SpiralsEndSimple) {
  for (double const width_px : {2.0, 8.0}) {
    Contour spiral;
    for (int side = 0; side < 2; ++side) {
      for (int k = 0; k <= 400; ++k) {
        int const i = side == 0 ? k : 400 - k;
        auto const [sine, cosine] = sin_cos(6 * kPi * i / 400);
        spiral.push_back(Vec2{512, 512} +
                         Vec2{cosine, sine} * (40 + i * 0.1 * width_px + side * width_px));
      }
    }
    HandMadeRims made;
    made.add(spiral);
    EXPECT_EQ(expect_valid_whatever_the_positions(made, 2), 1);
  }
}

TEST(FitRims, NeighboursThatAlmostTouchStayApart) {
  for (double const gap_px : {0.07, 0.5, 2.0}) {
    HandMadeRims made;
    made.add(resampled({{100, 100}, {500, 100}, {500, 500}, {100, 500}}));
    made.add(resampled({{500 + gap_px, 100}, {900, 100}, {900, 500}, {500 + gap_px, 500}}));
    made.add(resampled({{200, 100 + gap_px}, {200, 300}, {300, 300}, {300, 100 + gap_px}}));
    EXPECT_EQ(expect_valid_whatever_the_positions(made, 3), 1);
  }
}

TEST(FitRims, RimsThatShareASampleTouchOnlyThere) {
  HandMadeRims made;
  made.add(resampled({{100, 100}, {500, 500}, {100, 900}}));
  made.add(resampled({{900, 100}, {900, 900}, {500, 500}}));
  auto const is_shared = [&](RimPoint const& point) {
    return made.samples.lattice[point.sample] == LatticePoint{8000, 8000};
  };
  auto const shared = std::find_if(made.rims[0].begin(), made.rims[0].end(), is_shared);
  auto const same = std::find_if(made.rims[1].begin(), made.rims[1].end(), is_shared);
  ASSERT_TRUE(shared != made.rims[0].end() && same != made.rims[1].end());
  same->sample = shared->sample;
  Rng rng(4);
  auto const outlines = fitted(made, 1, rng, 0.5);
  std::vector<Contour> polygons;
  for (auto const& outline : outlines) polygons.push_back(flatten(outline, 0.01));
  for (auto const& polygon : polygons) EXPECT_TRUE(is_simple(polygon));
  auto const place = WorkSpace{}.canvas_point({500, 500});
  for (auto const& crossing : find_crossings(polygons, 100)) {
    auto const& a = polygons[crossing.contour_a];
    EXPECT_TRUE(a[crossing.edge_a] == place || a[(crossing.edge_a + 1) % std::ssize(a)] == place);
  }
}

TEST(FitRims, RimsOfRandomDrawingsEndSimple) {
  // 406 to 1129: joints that turn back, where curves cross between the points of a coarse polygon.
  for (std::uint64_t const seed : {406, 664, 702, 827, 940, 1129}) {
    auto const drawing = simplify(random_sketch(seed));
    ASSERT_TRUE(drawing.has_value());
    EXPECT_EQ(what_is_wrong(*drawing), "") << seed;
  }
}

}  // namespace
}  // namespace inkflate
