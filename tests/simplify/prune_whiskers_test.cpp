// SPDX-License-Identifier: Apache-2.0
#include "simplify/prune_whiskers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/crossings.h"
#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kWidthPx = 7;

/// The rims of a sketch that was drawn in work px, and what is left of them.
struct Pruned {
  std::vector<Rim> before;
  std::vector<Rim> after;
  StrokeSamples samples;
};

/// A 1000 px space: a dot in each corner sees to it.
Pruned prune(std::vector<Stroke> strokes) {
  strokes.push_back(line_stroke({{0, 0}}));
  strokes.push_back(line_stroke({{1000, 1000}}));
  auto const sketch = sketch_of(std::move(strokes));
  auto const cells = cells_of(sketch);
  Pruned result = {trace_rims(sketch, cells, labels_of(cells)), {}, cells.samples};
  for (auto const& rim : result.before) {
    auto rest = prune_whiskers(rim, cells.samples, kWidthPx);
    if (!rest.empty()) result.after.push_back(std::move(rest));
  }
  return result;
}

double farthest(Rim const& rim, StrokeSamples const& samples, Vec2 from) {
  double result = 0;
  for (auto const p : positions(rim, samples)) result = std::max(result, distance(p, from));
  return result;
}

TEST(PruneWhiskers, ADiscLosesAntennaeThatWereDrawnTwice) {
  auto strokes = std::vector<Stroke>{circle_stroke({500, 600}, 250)};
  for (double const aside_px : {0.0, 3.0}) {
    strokes.push_back(line_stroke({{420 + aside_px, 365}, {340 + aside_px, 100}}));
    strokes.push_back(line_stroke({{580 + aside_px, 365}, {660 + aside_px, 100}}));
  }
  auto const pruned = prune(strokes);
  ASSERT_FALSE(pruned.before.empty());
  ASSERT_EQ(pruned.after.size(), 1U);
  auto const contour = positions(pruned.after[0], pruned.samples);
  EXPECT_TRUE(is_simple(contour));
  EXPECT_NEAR(signed_area(contour), M_PI * 250 * 250, 0.02 * M_PI * 250 * 250);
  EXPECT_LT(farthest(pruned.after[0], pruned.samples, Vec2{512, 612}), 250 + 3 * kWidthPx);
}

TEST(PruneWhiskers, AThickLimbStays) {
  auto const pruned = prune({line_stroke({{300, 400},
                                          {480, 400},
                                          {480, 100},
                                          {520, 100},
                                          {520, 400},
                                          {700, 400},
                                          {700, 800},
                                          {300, 800},
                                          {300, 400}})});
  ASSERT_EQ(pruned.after.size(), 1U);
  EXPECT_EQ(pruned.after[0], pruned.before[0]);
}

TEST(PruneWhiskers, ASliverAloneVanishes) {
  auto const pruned =
      prune({line_stroke({{300, 500}, {700, 500}}), line_stroke({{300, 504}, {700, 504}})});
  ASSERT_FALSE(pruned.before.empty());
  EXPECT_TRUE(pruned.after.empty());
}

TEST(PruneWhiskers, TheFootOfAWhiskerIsInk) {
  auto const pruned = prune({circle_stroke({500, 600}, 250), line_stroke({{498, 365}, {498, 100}}),
                             line_stroke({{503, 365}, {503, 100}})});
  ASSERT_EQ(pruned.after.size(), 1U);
  auto const& rim = pruned.after[0];
  auto const points = positions(rim, pruned.samples);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    auto const& next = rim[(i + 1) % rim.size()];
    bool const was_edge =
        std::any_of(pruned.before.begin(), pruned.before.end(), [&](Rim const& old) {
          for (std::size_t k = 0; k < old.size(); ++k) {
            if (old[k].sample == rim[i].sample && old[(k + 1) % old.size()].sample == next.sample)
              return true;
          }
          return false;
        });
    if (was_edge) continue;
    EXPECT_EQ(rim[i].to_next, RunKind::Ink);
    EXPECT_LE(distance(points[i], points[(i + 1) % rim.size()]), kWidthPx);
  }
}

TEST(PruneWhiskers, WhatIsLeftIsSimpleAndOfOldCornersInOrder) {
  int cuts = 0;
  std::vector<std::uint64_t> seeds = {937};  // a cut that would cross the jagged foot
  for (std::uint64_t seed = 0; seed < 12; ++seed) seeds.push_back(seed);
  for (auto const seed : seeds) {
    auto const sketch = random_sketch(seed);
    auto const cells = cells_of(sketch);
    for (auto const& rim : trace_rims(sketch, cells, labels_of(cells))) {
      auto const rest = prune_whiskers(rim, cells.samples, kWidthPx);
      if (rest.empty()) continue;
      EXPECT_TRUE(is_simple(positions(rest, cells.samples))) << seed;
      std::size_t next = 0;
      for (auto const& point : rim) {
        if (next < rest.size() && rest[next].sample == point.sample) ++next;
      }
      EXPECT_EQ(next, rest.size()) << seed;
      cuts += rest.size() < rim.size() ? 1 : 0;
    }
  }
  EXPECT_GT(cuts, 5);
}

}  // namespace
}  // namespace inkflate
