// SPDX-License-Identifier: Apache-2.0
#include "simplify/fit_rim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/trig.h"
#include "support/rims.h"

namespace inkflate {
namespace {

Outline fit(Contour const& contour, FitOptions const& options,
            std::vector<RunKind> const& kinds = {}) {
  HandMadeRims made;
  made.add(contour, kinds);
  return fit_rim(made.rims[0], made.contour(0), made.samples, options);
}

TEST(FitRim, TheOnlyCornerOfADropStaysSharp) {
  Contour drop;
  for (int i = 0; i <= 300; ++i) {
    auto const [sine, cosine] = sin_cos(kPi / 2 + 1.5 * kPi * i / 300);
    drop.push_back(Vec2{500, 500} + Vec2{cosine, sine} * 200);
  }
  drop.push_back({700, 700});
  for (double const smooth : {0.0, 0.5, 1.0}) {
    auto const outline = fit(resampled(drop), {smooth, ClosingShape::Flowing});
    auto const& first = outline.pieces.front().curve;
    auto const& last = outline.pieces.back().curve;
    EXPECT_LT(distance(first.start(), {700, 700}), 0.5);
    auto const leaving = normalized(derivative_at(first, 0));
    auto const arriving = normalized(derivative_at(last, 1));
    EXPECT_NEAR(dot(leaving, arriving), 0, 0.1) << smooth;
  }
}

TEST(FitRim, ACircleGoesOnSmoothlyWhereItEnds) {
  Contour circle;
  for (int i = 0; i < 800; ++i) {
    auto const [sine, cosine] = sin_cos(2 * kPi * i / 800);
    circle.push_back(Vec2{500, 500} + Vec2{cosine, sine} * 300);
  }
  auto const outline = fit(circle, {});
  auto const& pieces = outline.pieces;
  EXPECT_LE(pieces.size(), 12U);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    auto const arriving = normalized(derivative_at(pieces[i].curve, 1));
    auto const leaving = normalized(derivative_at(pieces[(i + 1) % pieces.size()].curve, 0));
    EXPECT_GT(dot(arriving, leaving), 0.99999);
  }
  EXPECT_NEAR(signed_area(flatten(outline, 0.01)), kPi * 300 * 300, 0.003 * kPi * 300 * 300);
}

TEST(FitRim, ASquareIsFourPiecesAtItsCorners) {
  auto const outline = fit(resampled({{100, 100}, {500, 100}, {500, 500}, {100, 500}}), {});
  EXPECT_EQ(outline.pieces.size(), 4U);
  EXPECT_NEAR(signed_area(flatten(outline, 0.01)), 160'000, 50);
}

TEST(FitRim, ClosingsAreStraightOrFlowOn) {
  Contour arc;
  std::vector<RunKind> kinds;
  for (int i = 0; i <= 700; ++i) {
    auto const [sine, cosine] = sin_cos(0.3 + (2 * kPi - 0.6) * i / 700);
    arc.push_back(Vec2{500, 500} + Vec2{cosine, sine} * 300);
    kinds.push_back(i < 700 ? RunKind::Ink : RunKind::Closing);
  }
  double farthest[2] = {};
  for (auto const shape : {ClosingShape::Straight, ClosingShape::Flowing}) {
    auto const outline = fit(arc, {0.5, shape}, kinds);
    int closings = 0;
    for (auto const& run : runs(outline, 0.01)) {
      if (run.kind != RunKind::Closing) continue;
      ++closings;
      for (auto const p : run.points)
        farthest[static_cast<int>(shape)] = std::max(farthest[static_cast<int>(shape)], p.x);
    }
    EXPECT_EQ(closings, 1);
  }
  EXPECT_NEAR(farthest[static_cast<int>(ClosingShape::Straight)], 500 + 300 * sin_cos(0.3).cos, 1);
  EXPECT_NEAR(farthest[static_cast<int>(ClosingShape::Flowing)], 800, 4);
}

TEST(StraightOutline, IsTheRimWithItsKindsAndSources) {
  HandMadeRims made;
  made.add({{100, 100}, {500, 100}, {500, 500}, {100, 500}},
           {RunKind::Ink, RunKind::Closing, RunKind::HelpLine, RunKind::Ink});
  auto const outline = straight_outline(made.rims[0], made.samples);
  EXPECT_EQ(flatten(outline, 0.1).size(), 4U);
  EXPECT_DOUBLE_EQ(signed_area(flatten(outline, 0.1)), 160'000);
  EXPECT_EQ(outline.pieces[1].kind, RunKind::Closing);
  EXPECT_EQ(outline.pieces[2].kind, RunKind::HelpLine);
  ASSERT_EQ(outline.sources.size(), 2U);
  EXPECT_EQ(outline.sources[0], (InkSource{0, 1, 0, 0, 1}));
  EXPECT_EQ(outline.sources[1], (InkSource{2, 4, 0, 2, 0}));
}

}  // namespace
}  // namespace inkflate
