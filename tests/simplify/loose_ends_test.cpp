// SPDX-License-Identifier: Apache-2.0
#include "simplify/loose_ends.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// Where the loose ends are, canvas px. A stroke from corner to corner of 1000 x 1000 px makes a work px one of those.
std::vector<Vec2> ends_of(std::vector<Stroke> strokes) {
  auto const sketch = sketch_of(std::move(strokes));
  auto const samples = samples_of(sketch, 2.5);
  std::vector<Vec2> places;
  for (auto const& end : loose_ends(sketch, samples))
    places.push_back(space_of(sketch).canvas_point(samples.points[end.sample].position));
  return places;
}

Stroke ruler() { return line_stroke({{0, 0}, {0, 1000}}); }

void expect_places(std::vector<Vec2> const& found, std::vector<Vec2> const& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(distance(found[i], expected[i]), 0.1);
}

TEST(LooseEnds, BothEndsOfALineAreLoose) { expect_places(ends_of({ruler()}), {{0, 0}, {0, 1000}}); }

TEST(LooseEnds, AClosedStrokeHasNone) {
  expect_places(ends_of({ruler(), circle_stroke({500, 500}, 200)}), {{0, 0}, {0, 1000}});
}

TEST(LooseEnds, WhereAnotherStrokeGoesOnThereIsNone) {
  expect_places(ends_of({ruler(), line_stroke({{300, 300}, {500, 300}}),
                         line_stroke({{506, 303}, {700, 303}})}),
                {{0, 0}, {0, 1000}, {300, 300}, {700, 303}});
}

TEST(LooseEnds, WhereAStrokeMeetsAnotherOneThereIsNone) {
  expect_places(ends_of({ruler(), line_stroke({{4, 500}, {300, 500}})}),
                {{0, 0}, {0, 1000}, {300, 500}});
}

TEST(LooseEnds, OfStrokesDrawnTwiceTheFartherEndIsLoose) {
  expect_places(ends_of({ruler(), line_stroke({{300, 300}, {500, 300}}),
                         line_stroke({{290, 305}, {520, 305}})}),
                {{0, 0}, {0, 1000}, {290, 305}, {520, 305}});
}

TEST(LooseEnds, AHelpLineTakesAnEnd) {
  expect_places(ends_of({ruler(), line_stroke({{300, 300}, {500, 300}}),
                         line_stroke({{500, 304}, {500, 400}}, StrokeKind::HelpLine)}),
                {{0, 0}, {0, 1000}, {300, 300}});
}

TEST(LooseEnds, DotsAndHatchesHaveNone) {
  expect_places(
      ends_of({ruler(), line_stroke({{300, 300}}), line_stroke({{400, 300}, {409, 309}})}),
      {{0, 0}, {0, 1000}});
}

TEST(LooseEnds, TellWhereTheirStrokeIs) {
  auto const sketch = sketch_of({ruler()});
  auto const samples = samples_of(sketch, 2.5);
  auto const ends = loose_ends(sketch, samples);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0], (LooseEnd{0, 1, ends[0].length_px}));
  EXPECT_EQ(ends[1], (LooseEnd{samples.drawn_count() - 1, -1, ends[0].length_px}));
  EXPECT_NEAR(ends[0].length_px, 1000, 1e-6);
}

}  // namespace
}  // namespace inkflate
