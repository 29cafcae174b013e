// SPDX-License-Identifier: Apache-2.0
#include "simplify/centre_rim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// The centred positions of the largest rim of a sketch.
struct Centred {
  Contour before;
  Contour after;
};

Centred centre(Sketch const& sketch) {
  auto const cells = cells_of(sketch);
  std::vector<Vec2> points;
  for (auto const& sample : cells.samples.points) points.push_back(sample.position);
  PointGrid const grid(points, CentreOptions{}.reach_px);
  Centred result;
  double largest = 0;
  for (auto const& rim : trace_rims(sketch, cells, labels_of(cells))) {
    auto const contour = positions(rim, cells.samples);
    if (signed_area(contour) <= largest) continue;
    largest = signed_area(contour);
    result = {contour, centre_rim(rim, cells.samples, grid)};
  }
  EXPECT_EQ(result.before.size(), result.after.size());
  return result;
}

double farthest_move(Centred const& centred) {
  double farthest = 0;
  for (std::size_t i = 0; i < centred.before.size(); ++i)
    farthest = std::max(farthest, distance(centred.before[i], centred.after[i]));
  return farthest;
}

TEST(CentreRim, ASingleLineStaysWhereItIs) {
  auto const centred = centre(sketch_of({circle_stroke({500, 500}, 500)}));
  ASSERT_FALSE(centred.after.empty());
  EXPECT_LT(farthest_move(centred), 0.3);
}

TEST(CentreRim, ParallelCirclesMeetInTheirMiddle) {
  for (double const apart_px : {2.0, 4.0, 6.0}) {
    auto const centred = centre(
        sketch_of({circle_stroke({500, 500}, 500), circle_stroke({500, 500}, 500 - apart_px)}));
    ASSERT_FALSE(centred.after.empty());
    for (auto const p : centred.after)
      EXPECT_NEAR(distance(p, {512, 512}), 500 - apart_px / 2, 0.7) << apart_px;
  }
}

TEST(CentreRim, EachPassCountsByItsLength) {
  auto const centred =
      centre(sketch_of({circle_stroke({500, 500}, 500), circle_stroke({500, 500}, 497),
                        circle_stroke({500, 500}, 496), circle_stroke({500, 500}, 495)}));
  for (auto const p : centred.after) EXPECT_NEAR(distance(p, {512, 512}), 497, 0.5);
}

TEST(CentreRim, LinesFartherApartThanTheGapAreTwo) {
  auto const centred =
      centre(sketch_of({circle_stroke({500, 500}, 500), circle_stroke({500, 500}, 490)}));
  ASSERT_FALSE(centred.after.empty());
  EXPECT_LT(farthest_move(centred), 0.3);
}

TEST(CentreRim, StrokesAcrossTheOutlineDoNotPullIt) {
  std::vector<Stroke> strokes = {line_stroke({{0, 0}, {1000, 0}, {1000, 600}, {0, 600}, {0, 0}})};
  for (int i = 1; i < 100; ++i) strokes.push_back(line_stroke({{10.0 * i, 0}, {10.0 * i, 60}}));
  auto const centred = centre(sketch_of(strokes));
  // Away from the corners, where the upper side is drawn with its neighbour.
  for (std::size_t i = 0; i < centred.before.size(); ++i) {
    if (centred.before[i].y > 12.1 || std::abs(centred.before[i].x - 512) > 400) continue;
    EXPECT_NEAR(centred.after[i].y, 12, 0.3);
  }
}

TEST(CentreRim, AStraightBandStaysStraight) {
  std::vector<Stroke> strokes;
  for (double const aside_px : {0.0, 3.0, 5.0}) {
    strokes.push_back(line_stroke({{0, aside_px}, {1000, aside_px}}));
    strokes.push_back(line_stroke({{0, 600 - aside_px}, {1000, 600 - aside_px}}));
  }
  strokes.push_back(line_stroke({{0, 0}, {0, 600}}));
  strokes.push_back(line_stroke({{1000, 0}, {1000, 600}}));
  auto const centred = centre(sketch_of(strokes));
  ASSERT_FALSE(centred.after.empty());
  for (auto const p : centred.after) {
    if (std::abs(p.x - 512) > 450) continue;
    EXPECT_NEAR(std::abs(p.y - 312), 300 - 8.0 / 3, 0.4);
  }
}

TEST(CentreRim, AThinBandNeverCollapses) {
  for (double const width_px : {4.0, 6.0, 10.0, 20.0}) {
    // Closed at its ends, and with a corner far off, so that space and canvas are of one scale.
    auto const centred = centre(
        sketch_of({line_stroke({{0, 0}, {1000, 0}, {1000, width_px}, {0, width_px}, {0, 0}})}));
    ASSERT_FALSE(centred.after.empty());
    EXPECT_GE(signed_area(centred.after), signed_area(centred.before) / 3 - 20);
    for (std::size_t i = 0; i < centred.after.size(); ++i) {
      if (std::abs(centred.before[i].x - 512) > 450) continue;
      bool const is_upper = centred.before[i].y < 12 + width_px / 2;
      EXPECT_EQ(centred.after[i].y < 12 + width_px / 2, is_upper);
    }
  }
}

TEST(CentreRim, MovesAreBoundedOnAnyDrawing) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    auto const centred = centre(random_sketch(seed));
    EXPECT_LE(farthest_move(centred), CentreOptions{}.reach_px) << seed;
  }
}

}  // namespace
}  // namespace inkflate
