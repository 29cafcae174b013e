// SPDX-License-Identifier: Apache-2.0
#include "document/cut_stroke.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// Along the x axis from 0 to 100 in steps of 10, with pressure growing from 0 to 1 and a second for each step.
Stroke recorded_line() {
  Stroke stroke;
  for (int i = 0; i <= 10; ++i) stroke.samples.push_back({{i * 10.0, 0}, i / 10.0, 1.0 * i});
  return stroke;
}

std::vector<Stroke> remains(Stroke const& stroke, Polyline path, double radius_px) {
  auto pieces = Swept(std::move(path), radius_px).cut(stroke);
  EXPECT_TRUE(pieces.has_value());
  return pieces.value_or(std::vector<Stroke>{});
}

double length_px(Stroke const& stroke) {
  double sum = 0;
  for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
    sum += distance(stroke.samples[i - 1].position, stroke.samples[i].position);
  }
  return sum;
}

TEST(CutStroke, PiecesEndOnTheEdgeOfTheCircle) {
  // 3-4-5: the circle of radius 5 around (55, 4) crosses the axis 3 px to both sides.
  auto const pieces = remains(recorded_line(), {{55, 4}}, 5);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].samples.back().position.x, 52, 1e-12);
  EXPECT_NEAR(pieces[1].samples.front().position.x, 58, 1e-12);
}

TEST(CutStroke, PressureGoesOnAndTimeStartsAnew) {
  auto const pieces = remains(recorded_line(), {{55, 4}}, 5);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].samples.back().pressure, 0.52, 1e-12);
  EXPECT_NEAR(pieces[0].samples.back().time_s, 5.2, 1e-12);
  EXPECT_NEAR(pieces[1].samples.front().pressure, 0.58, 1e-12);
  EXPECT_EQ(pieces[1].samples.front().time_s, 0);
  EXPECT_NEAR(pieces[1].samples.back().time_s, 4.2, 1e-12);
  EXPECT_EQ(pieces[1].samples.back().pressure, 1);
}

TEST(CutStroke, TimesThatWereNotRecordedStayZero) {
  for (auto const& piece : remains(line_stroke({{0, 0}, {100, 0}}), {{50, 0}}, 5)) {
    for (auto const& sample : piece.samples) EXPECT_EQ(sample.time_s, 0);
  }
}

TEST(CutStroke, TimeThatRanBackwardsNeverFallsBelowZero) {
  auto stroke = recorded_line();
  for (auto& sample : stroke.samples) sample.time_s = 10 - sample.time_s;
  for (auto const& piece : remains(stroke, {{50, 0}}, 5)) {
    for (auto const& sample : piece.samples) EXPECT_GE(sample.time_s, 0);
  }
}

TEST(CutStroke, PiecesKeepTheLookOfTheStroke) {
  auto stroke = recorded_line();
  stroke.kind = StrokeKind::HelpLine;
  stroke.width_px = 7;
  stroke.group = 3;
  stroke.depth = StrokeDepth::Far;
  for (auto piece : remains(stroke, {{50, 0}}, 5)) {
    piece.samples = stroke.samples;
    EXPECT_EQ(piece, stroke);
  }
}

TEST(CutStroke, FastEraserRubsOutAllBetweenItsPoints) {
  // The path crosses the axis at right angles between its two points.
  auto const pieces = remains(recorded_line(), {{33, -500}, {33, 500}}, 4);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].samples.back().position.x, 29, 1e-9);
  EXPECT_NEAR(pieces[1].samples.front().position.x, 37, 1e-9);
}

TEST(CutStroke, PathAlongTheStrokeTakesItsRoundEnds) {
  auto const pieces = remains(recorded_line(), {{40, 0}, {60, 0}}, 5);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].samples.back().position.x, 35, 1e-12);
  EXPECT_NEAR(pieces[1].samples.front().position.x, 65, 1e-12);
}

TEST(CutStroke, OnlyTheEndsOfAStrokeMayGo) {
  auto const start = remains(recorded_line(), {{0, 0}}, 15);
  ASSERT_EQ(start.size(), 1U);
  EXPECT_NEAR(length_px(start[0]), 85, 1e-9);
  auto const end = remains(recorded_line(), {{100, 0}}, 15);
  ASSERT_EQ(end.size(), 1U);
  EXPECT_EQ(end[0].samples.front(), recorded_line().samples.front());
  EXPECT_NEAR(length_px(end[0]), 85, 1e-9);
}

TEST(CutStroke, StrokeWithinTheEraserGoesWhole) {
  EXPECT_TRUE(remains(recorded_line(), {{50, 0}}, 60).empty());
}

TEST(CutStroke, StrokeOutsideIsNotMet) {
  EXPECT_FALSE(Swept({{50, 20}}, 5).cut(recorded_line()));
  EXPECT_FALSE(Swept({{50, 20}}, 5).may_meet({{0, 0}, {100, 0}}));
  EXPECT_FALSE(Swept({{50, 5}}, 5).cut(recorded_line())) << "it only touches";
  EXPECT_FALSE(Swept({{50, 5}}, 5).cut(Stroke{})) << "a stroke without samples";
}

TEST(CutStroke, ErasingTwiceIsErasingOnce) {
  Rng rng(11);
  for (int i = 0; i < 200; ++i) {
    Polyline const path = {{rng.uniform(0, 100), rng.uniform(-9, 9)},
                           {rng.uniform(0, 100), rng.uniform(-9, 9)}};
    Swept const swept(path, rng.uniform(1, 20));
    auto const pieces = swept.cut(recorded_line());
    if (!pieces) continue;
    for (auto const& piece : *pieces) ASSERT_FALSE(swept.cut(piece)) << "path " << i;
  }
}

TEST(CutStroke, WhatRemainsIsWhatLiesOutside) {
  Rng rng(12);
  for (int i = 0; i < 100; ++i) {
    auto const stroke = circle_stroke({rng.uniform(-20, 20), rng.uniform(-20, 20)}, 30);
    Vec2 const from = {rng.uniform(-40, 40), rng.uniform(-40, 40)};
    Vec2 const to = {rng.uniform(-40, 40), rng.uniform(-40, 40)};
    double const radius_px = rng.uniform(1, 15);
    auto const pieces = Swept({from, to}, radius_px).cut(stroke);
    if (!pieces) continue;
    for (auto const& piece : *pieces) {
      for (std::size_t k = 1; k < piece.samples.size(); ++k) {
        auto const middle = lerp(piece.samples[k - 1].position, piece.samples[k].position, 0.5);
        ASSERT_GE(std::sqrt(squared_distance_to_segment(middle, from, to)), radius_px - 1e-6);
      }
    }
  }
}

TEST(CutStroke, CrumbsVanish) {
  // 0.3 px are left at each end.
  EXPECT_TRUE(remains(line_stroke({{0, 0}, {10, 0}}), {{5, 0}}, 4.7).empty());
}

TEST(CutStroke, DotGoesWhenTheEraserCoversIt) {
  EXPECT_TRUE(remains(line_stroke({{5, 5}}), {{5, 8}}, 4).empty());
  EXPECT_FALSE(Swept({{5, 8}}, 2).cut(line_stroke({{5, 5}})));
}

TEST(CutStroke, PenThatRestsIsErasedWithItsPlace) {
  auto const stroke = line_stroke({{0, 0}, {50, 0}, {50, 0}, {50, 0}, {100, 0}});
  auto const pieces = remains(stroke, {{50, 0}}, 10);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(length_px(pieces[0]) + length_px(pieces[1]), 80, 1e-9);
  auto const far = remains(stroke, {{0, 0}}, 10);
  ASSERT_EQ(far.size(), 1U);
  EXPECT_EQ(far[0].samples.size(), 5U);
}

TEST(CutStroke, TinyStepsOfThePenAreErasedToo) {
  Stroke stroke;
  for (int i = 0; i < 1000; ++i) stroke.samples.push_back({{i * 1e-8, 0}});
  EXPECT_TRUE(remains(stroke, {{0, 0}}, 1).empty());
}

TEST(CutStroke, TinyEraserCutsFarFromTheOrigin) {
  auto const pieces =
      Swept({{999'990, 999'000}}, 0.01).cut(line_stroke({{999'000, 999'000}, {1e6, 999'000}}));
  ASSERT_TRUE(pieces);
  EXPECT_EQ(pieces->size(), 2U);
}

}  // namespace
}  // namespace inkflate
