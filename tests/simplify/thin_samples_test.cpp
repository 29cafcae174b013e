// SPDX-License-Identifier: Apache-2.0
#include "simplify/thin_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/sketches.h"

namespace inkflate {
namespace {

StrokeSamples samples_of(Sketch const& sketch) {
  std::vector<int> all(sketch.strokes.size());
  std::iota(all.begin(), all.end(), 0);
  return sample_strokes(sketch, all, WorkSpace::around({{0, 0}, {1000, 1000}}), 2.5);
}

TEST(ThinSamples, KeepsApartAndLeavesNothingUncovered) {
  auto const sketch = sketch_of(overdrawn(circle_stroke({500, 500}, 100), 6, {0.7, 0.4}));
  auto const samples = samples_of(sketch);
  auto const thin = thin_samples(sketch, samples, 2);
  EXPECT_LT(thin.points.size(), samples.points.size() / 2);
  EXPECT_EQ(thin.points.size(), thin.lattice.size());
  auto const nearest = [&](Vec2 p, int except) {
    double best = 1e9;
    for (int i = 0; i < std::ssize(thin.points); ++i) {
      if (i != except) best = std::min(best, distance(thin.points[i].position, p));
    }
    return best;
  };
  for (int i = 0; i < std::ssize(thin.points); ++i)
    EXPECT_GE(nearest(thin.points[i].position, i), 2);
  for (auto const& sample : samples.points) EXPECT_LT(nearest(sample.position, -1), 2);
}

TEST(ThinSamples, SpacingGrowsByTheDistance) {
  auto const sketch = sketch_of({circle_stroke({500, 500}, 300)});
  EXPECT_EQ(thin_samples(sketch, samples_of(sketch), 2).spacing_px, 4.5);
}

TEST(ThinSamples, KeepsStrokeOrder) {
  auto const sketch = sketch_of(overdrawn(circle_stroke({500, 500}, 300), 4, {2, 0}));
  auto const thin = thin_samples(sketch, samples_of(sketch), 2);
  EXPECT_TRUE(std::is_sorted(
      thin.points.begin(), thin.points.end(),
      [](StrokeSample const& a, StrokeSample const& b) { return a.stroke < b.stroke; }));
}

TEST(ThinSamples, HelpLinesStayBesideInk) {
  auto const sketch = sketch_of({line_stroke({{100, 100}, {300, 100}}),
                                 line_stroke({{100, 100}, {300, 100}}, StrokeKind::HelpLine)});
  auto const thin = thin_samples(sketch, samples_of(sketch), 2);
  auto const help = std::count_if(thin.points.begin(), thin.points.end(),
                                  [](StrokeSample const& sample) { return sample.stroke == 1; });
  EXPECT_GT(help, 60);
}

TEST(ThinSamples, NothingStaysNothing) { EXPECT_TRUE(thin_samples({}, {}, 2).points.empty()); }

}  // namespace
}  // namespace inkflate
