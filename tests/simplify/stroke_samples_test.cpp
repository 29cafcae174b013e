// SPDX-License-Identifier: Apache-2.0
#include "simplify/stroke_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// Where a stroke is at index + fraction, work px.
Vec2 place(Stroke const& stroke, WorkSpace const& space, double along) {
  auto const i = static_cast<std::size_t>(along);
  auto const a = space.work_point(stroke.samples[i].position);
  if (i + 1 == stroke.samples.size()) return a;
  return lerp(a, space.work_point(stroke.samples[i + 1].position), along - std::floor(along));
}

bool holds(StrokeSamples const& samples, Vec2 p) {
  return std::any_of(samples.points.begin(), samples.points.end(), [&](StrokeSample const& sample) {
    return distance(sample.position, p) < 1e-9;
  });
}

void expect_samples(Sketch const& sketch, double spacing_px) {
  auto const space = space_of(sketch);
  auto const samples = samples_of(sketch, spacing_px);
  auto const& points = samples.points;
  EXPECT_EQ(samples.spacing_px, spacing_px);
  EXPECT_EQ(samples.lattice.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto const& stroke = sketch.strokes[points[i].stroke];
    EXPECT_LT(distance(points[i].position, place(stroke, space, points[i].along)), 1e-6);
    EXPECT_LT(distance(points[i].position, WorkSpace::lattice_position(samples.lattice[i])),
              0.75 / WorkSpace::kLatticePerPx);
    double const size = norm(points[i].direction);
    EXPECT_TRUE(std::abs(size - 1) < 1e-9 || size == 0);
    if (i == 0 || points[i].stroke != points[i - 1].stroke) {
      EXPECT_EQ(points[i].along, 0);
      EXPECT_TRUE(i == 0 || points[i].stroke > points[i - 1].stroke);
      continue;
    }
    EXPECT_LE(distance(points[i].position, points[i - 1].position), spacing_px * (1 + 1e-9));
    EXPECT_GT(points[i].along, points[i - 1].along);
  }
  for (auto const& stroke : sketch.strokes) {
    if (stroke.samples.empty()) continue;
    EXPECT_TRUE(holds(samples, space.work_point(stroke.samples.front().position)));
    EXPECT_TRUE(holds(samples, space.work_point(stroke.samples.back().position)));
  }
}

TEST(StrokeSamples, LieOnTheirStrokesAtShortSteps) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_samples(random_sketch(seed), seed % 2 == 0 ? 2.2 : 17);
  }
}

TEST(StrokeSamples, RepeatedSamplesKeepTheirIndices) {
  auto const sketch =
      sketch_of({line_stroke({{0, 0}, {0, 0}, {0, 0}, {500, 0}, {500, 0}, {1000, 0}, {1000, 0}})});
  auto const samples = samples_of(sketch, 250);
  ASSERT_EQ(samples.points.size(), 5U);
  EXPECT_DOUBLE_EQ(samples.points[1].along, 2.5);
  EXPECT_DOUBLE_EQ(samples.points[3].along, 4.5);
  expect_samples(sketch, 3);
}

TEST(StrokeSamples, CornersOfPolygonsStay) {
  std::vector<Vec2> const corners = {{0, 0}, {333, 0}, {777, 500}, {10, 700}, {0, 1000}, {5, 7}};
  auto const sketch = sketch_of({line_stroke(corners)});
  auto const samples = samples_of(sketch);
  for (auto const corner : corners)
    EXPECT_TRUE(holds(samples, space_of(sketch).work_point(corner)));
}

TEST(StrokeSamples, ADotIsOneSampleWithoutDirection) {
  auto const samples =
      samples_of(sketch_of({line_stroke({{0, 0}, {1000, 0}}), line_stroke({{7, 7}}), Stroke{},
                            line_stroke({{9, 9}, {9, 9}})}),
                 500);
  ASSERT_EQ(samples.points.size(), 5U);
  EXPECT_EQ(samples.points[0].direction, (Vec2{1, 0}));
  EXPECT_EQ(samples.points[3].stroke, 1);
  EXPECT_EQ(samples.points[3].direction, (Vec2{0, 0}));
  EXPECT_EQ(samples.points[4].stroke, 3);
}

TEST(StrokeSamples, OnlyTheChosenStrokesAreTaken) {
  auto const sketch = sketch_of({line_stroke({{0, 0}, {1000, 0}}), line_stroke({{0, 9}, {1000, 9}}),
                                 line_stroke({{0, 99}, {1000, 99}})});
  std::vector<int> const chosen = {0, 2};
  auto const samples = sample_strokes(sketch, chosen, space_of(sketch), 10);
  EXPECT_EQ(samples.points.size(), 202U);
  EXPECT_TRUE(std::none_of(samples.points.begin(), samples.points.end(),
                           [](StrokeSample const& sample) { return sample.stroke == 1; }));
}

TEST(StrokeSamples, AboveTheCapTheSpacingGrows) {
  std::vector<Stroke> strokes;
  for (int i = 0; i < 900; ++i) strokes.push_back(line_stroke({{0, i * 1.0}, {1000, i * 1.0}}));
  auto const samples = samples_of(sketch_of(strokes), 2.2);
  EXPECT_NEAR(samples.spacing_px, 3, 1e-9);  // 900 000 px of strokes, 300 000 samples
  EXPECT_LE(samples.points.size(), 300'000U + 2 * 900);
  EXPECT_LE(distance(samples.points[0].position, samples.points[1].position), 3 + 1e-9);
}

TEST(StrokeSamples, AChordAddsSamplesBetweenItsEnds) {
  auto samples = samples_of(sketch_of({line_stroke({{0, 0}, {1000, 0}})}), 2.5);
  int const drawn = static_cast<int>(std::ssize(samples.points));
  EXPECT_EQ(samples.drawn_count(), drawn);
  append_chord({{100, 200}, {200, 200}}, 1, samples);
  ASSERT_EQ(std::ssize(samples.points), drawn + 39);
  EXPECT_EQ(samples.lattice.size(), samples.points.size());
  EXPECT_EQ(samples.drawn_count(), drawn);
  EXPECT_FALSE(samples.is_chord(drawn - 1));
  for (int k = 0; k < 39; ++k) {
    auto const& sample = samples.points[drawn + k];
    EXPECT_TRUE(samples.is_chord(drawn + k));
    EXPECT_LT(distance(sample.position, {102.5 + 2.5 * k, 200}), 1e-9);
    EXPECT_EQ(sample.direction, (Vec2{1, 0}));
    EXPECT_EQ(sample.stroke, 1);
  }
}

TEST(StrokeSamples, AChordShorterThanTheSpacingAddsNone) {
  auto samples = samples_of(sketch_of({line_stroke({{0, 0}, {1000, 0}})}), 2.5);
  for (auto const to : {Vec2{100, 200}, Vec2{102, 200}}) append_chord({{100, 200}, to}, 1, samples);
  EXPECT_EQ(samples.chord_count, 0);
}

}  // namespace
}  // namespace inkflate
