// SPDX-License-Identifier: Apache-2.0
#include "model/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rng.h"

namespace inkflate {
namespace {

/// A square of 100 px whose sides are straight pieces of the given kinds, as many per side as it takes.
Outline square_of(std::vector<RunKind> const& kinds) {
  int const count = static_cast<int>(std::ssize(kinds));
  auto const corner = [&](int i) {
    double const s = 4.0 * (i % count) / count;
    double const t = (s - std::floor(s)) * 100;
    if (s < 1) return Vec2{t, 0};
    if (s < 2) return Vec2{100, t};
    if (s < 3) return Vec2{100 - t, 100};
    return Vec2{0, 100 - t};
  };
  Outline outline;
  for (int i = 0; i < count; ++i)
    outline.pieces.push_back({line_cubic(corner(i), corner(i + 1)), kinds[i]});
  return outline;
}

TEST(Flatten, StartsNowhereTwice) {
  auto const contour = flatten(square_of(std::vector<RunKind>(4, RunKind::Ink)), 0.1);
  EXPECT_EQ(contour.size(), 4U);
  EXPECT_DOUBLE_EQ(signed_area(contour), 10000);
}

TEST(Flatten, ChordsStayWithinToleranceOfTheCurve) {
  // A circle of radius 100 as four cubics (Riskus 2006: 0.5519 r).
  double const k = 55.19;
  Outline circle;
  circle.pieces = {{{{Vec2{100, 0}, Vec2{100, k}, Vec2{k, 100}, Vec2{0, 100}}}},
                   {{{Vec2{0, 100}, Vec2{-k, 100}, Vec2{-100, k}, Vec2{-100, 0}}}},
                   {{{Vec2{-100, 0}, Vec2{-100, -k}, Vec2{-k, -100}, Vec2{0, -100}}}},
                   {{{Vec2{0, -100}, Vec2{k, -100}, Vec2{100, -k}, Vec2{100, 0}}}}};
  std::size_t fewest = 1000;
  for (double const tolerance_px : {0.01, 0.1, 1.0}) {
    auto const contour = flatten(circle, tolerance_px);
    for (std::size_t i = 0; i < contour.size(); ++i) {
      EXPECT_NEAR(norm(contour[i]), 100, 0.03);
      auto const middle = lerp(contour[i], contour[(i + 1) % contour.size()], 0.5);
      EXPECT_GE(norm(middle), 100 - 0.03 - tolerance_px);
    }
    EXPECT_LT(contour.size(), fewest);
    fewest = contour.size();
  }
}

TEST(Runs, AnOutlineOfOneKindIsOneClosedRun) {
  auto const found = runs(square_of(std::vector<RunKind>(8, RunKind::Ink)), 0.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].points.front(), found[0].points.back());
  EXPECT_EQ(found[0].points.size(), 9U);
}

TEST(Runs, StartAtAChangeOfKind) {
  // The first and the last piece belong together.
  auto const found =
      runs(square_of({RunKind::Ink, RunKind::Closing, RunKind::HelpLine, RunKind::Ink}), 0.1);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].kind, RunKind::Closing);
  EXPECT_EQ(found[1].kind, RunKind::HelpLine);
  EXPECT_EQ(found[2].kind, RunKind::Ink);
  EXPECT_EQ(found[2].points, (Polyline{{0, 100}, {0, 0}, {100, 0}}));
}

TEST(Runs, AreMaximalAndCoverTheOutlineInOrder) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    std::vector<RunKind> kinds(static_cast<std::size_t>(4 + 4 * rng.below(4)));
    int const different = 1 + rng.below(3);
    for (auto& kind : kinds) kind = static_cast<RunKind>(rng.below(different));
    auto const found = runs(square_of(kinds), 0.1);
    double total = 0;
    double ink = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      auto const& next = found[(i + 1) % found.size()];
      EXPECT_EQ(found[i].points.back(), next.points.front());
      if (found.size() > 1) {
        EXPECT_NE(found[i].kind, next.kind);
      }
      total += length(found[i].points);
      ink += found[i].kind == RunKind::Ink ? length(found[i].points) : 0;
    }
    EXPECT_NEAR(total, 400, 1e-9);
    auto const ink_pieces = std::count(kinds.begin(), kinds.end(), RunKind::Ink);
    EXPECT_NEAR(ink, 400.0 * static_cast<double>(ink_pieces) / static_cast<double>(kinds.size()),
                1e-9);
  }
}

TEST(Runs, NothingGivesNothing) {
  EXPECT_TRUE(runs({}, 0.1).empty());
  EXPECT_TRUE(flatten({}, 0.1).empty());
}

TEST(Drawing, ADuplicateLiesBehindWithStrokesOfItsOwn) {
  Drawing drawing;
  drawing.sketch.strokes.resize(2);
  drawing.sketch.strokes[1].samples = {{{1, 1}, 0.5}};
  Outline outline;
  outline.sources = {{0, 1, 1, 0, 0}};
  drawing.layers = {{"body", {}, {}, {}}, {"leg", {outline}, {1}, {0}, 4.0, Colour{9, 9, 9, 255}}};
  duplicate_behind(drawing, 1);
  ASSERT_EQ(drawing.layers.size(), 3U);
  auto const& copy = drawing.layers[0];
  EXPECT_EQ(copy.name, "leg copy");
  EXPECT_EQ(copy.thickness, 4.0);
  EXPECT_EQ(copy.fill, (Colour{9, 9, 9, 255}));
  ASSERT_EQ(drawing.sketch.strokes.size(), 4U);
  EXPECT_EQ(copy.strokes, std::vector{2});
  EXPECT_EQ(copy.details, std::vector{3});
  EXPECT_EQ(copy.outlines[0].sources[0].stroke, 2);
  EXPECT_EQ(drawing.sketch.strokes[2].samples, drawing.sketch.strokes[1].samples);
  EXPECT_EQ(drawing.sketch.groups[drawing.sketch.strokes[2].group].name, "leg copy");
  EXPECT_EQ(drawing.layers[2].strokes, std::vector{1});
}

/// A layer of each state, with a stroke of its own each: plain, hidden, without outline; and a stray stroke.
Drawing drawing_of_states() {
  Drawing drawing;
  drawing.sketch.strokes.resize(4);
  for (int i = 0; i < 4; ++i) drawing.sketch.strokes[i].width_px = i;
  Outline const square = square_of(std::vector<RunKind>(4, RunKind::Ink));
  drawing.layers = {
      {"plain", {square}, {0}, {}}, {"hidden", {square}, {}, {1}}, {"open", {}, {2}, {}}};
  drawing.layers[1].is_hidden = true;
  drawing.layers[2].is_open = true;
  drawing.stray = {3};
  return drawing;
}

TEST(Shown, LayersAreThoseWithOutlinesThatAreNotHidden) {
  auto const drawing = drawing_of_states();
  auto const seen = shown(drawing);
  EXPECT_EQ(seen.layers, std::vector<Layer>{drawing.layers[0]});
  EXPECT_EQ(seen.sketch, drawing.sketch);
  EXPECT_FALSE(is_shown({"empty", {Outline{}}, {}, {}}));
}

TEST(Shown, AnOpenLayerIsSeenAsItWas) {
  auto drawing = drawing_of_states();
  drawing.layers[0].is_open = true;
  EXPECT_TRUE(is_shown(drawing.layers[0]));
}

TEST(Shown, StrokesAreAllButThoseOfHiddenLayers) {
  auto const strokes = shown_sketch(drawing_of_states()).strokes;
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_EQ(strokes[0].width_px, 0);
  EXPECT_EQ(strokes[1].width_px, 2);
  EXPECT_EQ(strokes[2].width_px, 3);
}

TEST(DuplicateBehind, CopiesAllStrokesAndLeavesTheIdAlone) {
  auto drawing = drawing_of_states();
  auto& layer = drawing.layers[0];
  layer.id = LayerId{5};
  layer.noise = {2};
  layer.outlines[0].sources = {{0, 1, 0, 0, 1}, {1, 2, -1, 0, 0}};
  duplicate_behind(drawing, 0);
  auto const& copy = drawing.layers[0];
  EXPECT_EQ(copy.id, LayerId::None);
  EXPECT_EQ(copy.strokes, std::vector<int>{4});
  EXPECT_EQ(copy.noise, std::vector<int>{5});
  EXPECT_EQ(copy.outlines[0].sources[0].stroke, 4);
  EXPECT_EQ(copy.outlines[0].sources[1].stroke, -1);
}

}  // namespace
}  // namespace inkflate
