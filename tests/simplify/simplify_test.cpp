// SPDX-License-Identifier: Apache-2.0
#include "simplify/simplify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "support/sketches.h"

namespace inkflate {
namespace {

double area(Outline const& outline) { return signed_area(flatten(outline, 0.1)); }

/// How far the outline leaves a circle about (500, 500).
double distance_from_circle(Outline const& outline, double radius) {
  double worst = 0;
  for (auto const p : flatten(outline, 0.1))
    worst = std::max(worst, std::abs(distance(p, {500, 500}) - radius));
  return worst;
}

double kind_length(Outline const& outline, RunKind kind) {
  double sum = 0;
  for (auto const& run : runs(outline, 0.1)) sum += run.kind == kind ? length(run.points) : 0;
  return sum;
}

/// The only layer of a sketch that must have one.
Layer only_layer(Sketch const& sketch, SimplifyOptions const& options = {}) {
  auto const drawing = simplify(sketch, options);
  EXPECT_TRUE(drawing.has_value()) << drawing.error().message;
  if (!drawing) return {};
  EXPECT_EQ(what_is_wrong(*drawing), "");
  EXPECT_EQ(drawing->layers.size(), 1U);
  return drawing->layers.front();
}

ErrorCode refusal(Sketch const& sketch, SimplifyOptions const& options = {}) {
  auto const drawing = simplify(sketch, options);
  EXPECT_FALSE(drawing.has_value());
  return drawing ? ErrorCode::FileSystem : drawing.error().code;
}

TEST(Simplify, ACircleStaysThatCircle) {
  auto const layer = only_layer(sketch_of({circle_stroke({500, 500}, 300)}));
  ASSERT_EQ(layer.outlines.size(), 1U);
  EXPECT_LT(distance_from_circle(layer.outlines[0], 300), 1);
  EXPECT_NEAR(area(layer.outlines[0]), M_PI * 300 * 300, 0.005 * M_PI * 300 * 300);
  EXPECT_DOUBLE_EQ(kind_length(layer.outlines[0], RunKind::Closing), 0);
  EXPECT_LE(layer.outlines[0].pieces.size(), 16U);
}

TEST(Simplify, AGapIsClosedByATaggedPiece) {
  auto const layer = only_layer(sketch_of({arc_stroke({500, 500}, 300, 300, 0.2, 2 * M_PI - 0.2)}));
  // The gap is a chord of 0.4 rad.
  EXPECT_NEAR(kind_length(layer.outlines[0], RunKind::Closing), 2 * 300 * std::sin(0.2), 6);
  EXPECT_NEAR(area(layer.outlines[0]), M_PI * 300 * 300, 0.02 * M_PI * 300 * 300);
}

TEST(Simplify, AClosingFlowsOnInTheStrokesDirection) {
  auto const layer =
      only_layer(sketch_of({arc_stroke({500, 500}, 300, 300, 0.25, 2 * M_PI - 0.25)}));
  double farthest = 0;
  for (auto const p : flatten(layer.outlines[0], 0.1)) farthest = std::max(farthest, p.x);
  EXPECT_GT(farthest, 500 + 300 * std::cos(0.25) + 5);  // a straight closing would end there
}

TEST(Simplify, EnergyDecidesWhichGapsClose) {
  // Closing costs 17 per px of gap, leaving open 3 per px of the outline's inner side: gap < 0.18 * length closes.
  for (double const gap_share : {0.11, 0.25}) {
    double const gap_px = gap_share * 1600;
    Sketch const square = sketch_of({line_stroke({{500 - gap_px / 2, 300},
                                                  {300, 300},
                                                  {300, 700},
                                                  {700, 700},
                                                  {700, 300},
                                                  {500 + gap_px / 2, 300}})});
    bool const closes = 17 * gap_px < 3 * (1600 - gap_px);
    auto const drawing = simplify(square);
    EXPECT_EQ(drawing.has_value(), closes) << gap_share;
  }
}

TEST(Simplify, OverdrawnStrokesEndInTheirMiddle) {
  std::vector<Stroke> strokes;
  for (double const radius : {292.0, 295.0, 297.0, 300.0})
    strokes.push_back(circle_stroke({500, 500}, radius));
  auto const layer = only_layer(sketch_of(strokes));
  EXPECT_LT(distance_from_circle(layer.outlines[0], 296), 1);
  EXPECT_EQ(layer.strokes.size(), 4U);
}

TEST(Simplify, CornersStaySharp) {
  auto const layer = only_layer(
      sketch_of({line_stroke({{200, 200}, {800, 200}, {800, 800}, {200, 800}, {200, 200}})}));
  EXPECT_EQ(layer.outlines[0].pieces.size(), 4U);
  for (Vec2 const corner : {Vec2{200, 200}, {800, 200}, {800, 800}, {200, 800}}) {
    double nearest = 1e9;
    for (auto const& piece : layer.outlines[0].pieces)
      nearest = std::min(nearest, distance(piece.curve.start(), corner));
    EXPECT_LT(nearest, 1.5);
  }
}

TEST(Simplify, AHelpLineBecomesAnOpenRun) {
  auto const layer =
      only_layer(sketch_of({arc_stroke({500, 500}, 300, 300, 0, M_PI),
                            line_stroke({{200, 500}, {800, 500}}, StrokeKind::HelpLine)}));
  EXPECT_NEAR(kind_length(layer.outlines[0], RunKind::HelpLine), 600, 12);
  EXPECT_NEAR(kind_length(layer.outlines[0], RunKind::Ink), M_PI * 300, 12);
}

TEST(Simplify, NoiseOutsideAndScribblesInsideDoNotDisturb) {
  auto strokes = std::vector<Stroke>{circle_stroke({500, 500}, 300)};
  for (int i = 0; i < 8; ++i)
    strokes.push_back(line_stroke({{20.0 + 3 * i, 40.0 * i}, {45.0 + 2 * i, 40.0 * i + 11}}));
  for (int i = 0; i < 30; ++i)
    strokes.push_back(line_stroke({{380, 400 + 7.0 * i}, {620, 390 + 7.0 * i}}));
  auto const drawing = simplify(sketch_of(strokes));
  ASSERT_TRUE(drawing.has_value());
  ASSERT_EQ(drawing->layers.size(), 1U);
  EXPECT_EQ(what_is_wrong(*drawing), "");
  EXPECT_NEAR(area(drawing->layers[0].outlines[0]), M_PI * 300 * 300, 0.01 * M_PI * 300 * 300);
  EXPECT_EQ(drawing->stray.size(), 8U);
  EXPECT_EQ(drawing->layers[0].details.size(), 30U);
}

TEST(Simplify, FaintConstructionLinesCloseNothing) {
  // A ground line under two legs: in ink it would close the space between them.
  std::vector<Stroke> strokes = {line_stroke({{300, 800},
                                              {300, 200},
                                              {700, 200},
                                              {700, 800},
                                              {640, 800},
                                              {640, 400},
                                              {360, 400},
                                              {360, 800},
                                              {300, 800}}),
                                 line_stroke({{250, 803}, {750, 803}})};
  auto const inked = only_layer(sketch_of(strokes), {.holes = Holes::Fill});
  strokes[1].colour = {170, 190, 220};
  auto const pencilled = only_layer(sketch_of(strokes), {.holes = Holes::Fill});
  EXPECT_NEAR(area(inked.outlines[0]), 400 * 600, 3000);
  EXPECT_NEAR(area(pencilled.outlines[0]), 400 * 600 - 280 * 400, 3000);
  EXPECT_EQ(pencilled.strokes, std::vector<int>{0});
}

TEST(Simplify, LooseStrokesAreKeptAsDetails) {
  auto const layer =
      only_layer(sketch_of({circle_stroke({500, 600}, 250), line_stroke({{420, 365}, {340, 150}}),
                            line_stroke({{580, 365}, {660, 150}})}));
  EXPECT_EQ(layer.strokes, std::vector<int>{0});
  EXPECT_EQ(layer.details, (std::vector<int>{1, 2}));
  EXPECT_NEAR(area(layer.outlines[0]), M_PI * 250 * 250, 0.03 * M_PI * 250 * 250);
}

TEST(Simplify, EveryDrawnPieceKnowsItsStroke) {
  auto const sketch = sketch_of({arc_stroke({500, 500}, 300, 300, 0, M_PI),
                                 arc_stroke({500, 500}, 300, 300, M_PI, 2 * M_PI)});
  auto const layer = only_layer(sketch);
  double covered = 0;
  for (auto const& source : layer.outlines[0].sources) {
    covered += source.to - source.from;
    auto const piece = static_cast<std::size_t>(source.from);
    auto const on_outline =
        point_at(layer.outlines[0].pieces[piece].curve, source.from - std::floor(source.from));
    auto const& samples = sketch.strokes[source.stroke].samples;
    auto const on_stroke = samples[static_cast<std::size_t>(source.sample_from + 0.5)].position;
    EXPECT_LT(distance(on_outline, on_stroke), 12);
  }
  EXPECT_GT(covered, 0.9 * static_cast<double>(layer.outlines[0].pieces.size()));
}

/// A block with a deep bay from its top; one stroke.
Sketch bay_sketch() {
  return sketch_of({line_stroke({{460, 200},
                                 {460, 700},
                                 {540, 700},
                                 {540, 200},
                                 {900, 200},
                                 {900, 900},
                                 {100, 900},
                                 {100, 200},
                                 {460, 200}})});
}

TEST(Simplify, AnOutsideMarkOpensABay) {
  // A deep bay with a narrow mouth is filled; one click in it opens it.
  double const filled = area(only_layer(bay_sketch(), {.holes = Holes::Fill}).outlines[0]);
  double const opened =
      area(only_layer(bay_sketch(), {.outside = {{500, 450}}, .holes = Holes::Fill}).outlines[0]);
  EXPECT_NEAR(filled, 800 * 700, 3000);
  EXPECT_NEAR(filled - opened, 80 * 500, 3000);
}

TEST(Simplify, ABayOfTheSilhouettesOwnStrokesStaysOpen) {
  EXPECT_NEAR(area(only_layer(bay_sketch()).outlines[0]), 800 * 700 - 80 * 500, 3000);
}

TEST(Simplify, AnInsideMarkFillsWhatWouldStayOpen) {
  Sketch const open = sketch_of({line_stroke({{200, 200}, {200, 800}, {800, 800}, {800, 200}}),
                                 line_stroke({{190, 195}, {210, 190}})});
  EXPECT_EQ(refusal(open), ErrorCode::NothingThere);
  EXPECT_NEAR(area(only_layer(open, {.inside = {{500, 500}}}).outlines[0]), 600 * 600, 6000);
}

TEST(Simplify, TheGapOptionIsALimitInBothDirections) {
  Sketch const two_gaps =
      sketch_of({line_stroke({{480, 200}, {200, 200}, {200, 800}, {400, 800}}),
                 line_stroke({{600, 800}, {800, 800}, {800, 200}, {520, 200}})});
  EXPECT_EQ(refusal(two_gaps, {.gap_px = 100}), ErrorCode::NothingThere);
  auto const layer = only_layer(two_gaps, {.gap_px = 210});
  EXPECT_NEAR(kind_length(layer.outlines[0], RunKind::Closing), 240, 8);
}

TEST(Simplify, APartForEachSeparatePieceLargestFirst) {
  Sketch const sketch = sketch_of({circle_stroke({200, 300}, 90), circle_stroke({650, 500}, 250)});
  auto const all = simplify(sketch, {.parts = Parts::All});
  ASSERT_TRUE(all.has_value());
  ASSERT_EQ(all->layers.size(), 2U);
  EXPECT_EQ(all->layers[0].strokes, std::vector<int>{1});
  EXPECT_EQ(only_layer(sketch, {.parts = Parts::One}).strokes, std::vector<int>{1});
}

TEST(Simplify, GroupsBecomeLayersOfTheirOwn) {
  Sketch sketch = sketch_of({circle_stroke({400, 500}, 250), circle_stroke({650, 500}, 200),
                             circle_stroke({500, 500}, 30)});
  sketch.groups = {{"body"}, {"head"}};
  sketch.strokes[0].group = 0;
  sketch.strokes[1].group = 1;
  sketch.strokes[2].group = 0;
  auto const drawing = simplify(sketch, {.parts = Parts::Groups});
  ASSERT_TRUE(drawing.has_value());
  ASSERT_EQ(drawing->layers.size(), 2U);
  EXPECT_EQ(drawing->layers[0].name, "body");
  EXPECT_EQ(drawing->layers[0].details, std::vector<int>{2});
  EXPECT_EQ(drawing->layers[1].name, "head");
  EXPECT_NEAR(area(drawing->layers[1].outlines[0]), M_PI * 200 * 200, 0.02 * M_PI * 200 * 200);
}

TEST(Simplify, NoPieceOfAGroupIsLost) {
  Sketch sketch = sketch_of({circle_stroke({300, 500}, 100), circle_stroke({700, 500}, 90)});
  sketch.groups = {{"legs"}};
  for (auto& stroke : sketch.strokes) stroke.group = 0;
  auto const drawing = simplify(sketch, {.parts = Parts::Groups});
  ASSERT_TRUE(drawing.has_value());
  ASSERT_EQ(drawing->layers.size(), 2U);
  EXPECT_EQ(drawing->layers[0].name, "legs");
  EXPECT_EQ(drawing->layers[1].name, "legs 2");
}

TEST(Simplify, LayersLookAsTheirGroupSays) {
  Sketch sketch = sketch_of({circle_stroke({300, 500}, 100), circle_stroke({700, 500}, 90)});
  sketch.groups = {{"leg", Colour{1, 2, 3}, 5}};
  sketch.strokes[0].group = 0;
  for (auto const parts : {Parts::Groups, Parts::All}) {
    auto const drawing = simplify(sketch, {.parts = parts});
    ASSERT_TRUE(drawing.has_value());
    ASSERT_EQ(drawing->layers.size(), 2U);
    EXPECT_EQ(drawing->layers[0].name, "leg");
    EXPECT_EQ(drawing->layers[0].fill, (Colour{1, 2, 3}));
    EXPECT_EQ(drawing->layers[0].thickness, 5);
    EXPECT_FALSE(drawing->layers[1].fill.has_value());
    EXPECT_EQ(drawing->layers[1].thickness, 2);
  }
}

TEST(Simplify, AGroupOfNoiseBecomesNoLayer) {
  for (char const* name : {"Noise", "construction", "help lines"}) {
    Sketch sketch = sketch_of({circle_stroke({300, 500}, 100), circle_stroke({700, 500}, 90)});
    sketch.groups = {{name}, {"body"}};
    sketch.strokes[0].group = 0;
    sketch.strokes[1].group = 1;
    auto const drawing = simplify(sketch, {.parts = Parts::Groups});
    ASSERT_TRUE(drawing.has_value());
    ASSERT_EQ(drawing->layers.size(), 1U) << name;
    EXPECT_EQ(drawing->layers[0].name, "body");
    EXPECT_EQ(drawing->stray, std::vector<int>{0});
  }
}

TEST(Simplify, ScaleAndPlaceChangeNothing) {
  auto sketch = sketch_of(
      {arc_stroke({500, 500}, 300, 220, 0.2, 6.1), line_stroke({{400, 450}, {600, 480}})});
  auto const expected = area(only_layer(sketch).outlines[0]);
  for (double const scale : {1e-3, 7.0, 900.0}) {
    auto scaled = sketch;
    for (auto& stroke : scaled.strokes) {
      for (auto& sample : stroke.samples)
        sample.position = sample.position * scale + Vec2{1000, -500};
    }
    auto const contour = flatten(only_layer(scaled).outlines[0], 0.1 * scale);
    EXPECT_NEAR(signed_area(contour) / (scale * scale), expected, 0.001 * expected);
  }
}

TEST(Simplify, WhatEnclosesNothingIsRefusedWithAdvice) {
  EXPECT_EQ(refusal(sketch_of({})), ErrorCode::NothingThere);
  EXPECT_EQ(refusal(sketch_of({Stroke{}, Stroke{}})), ErrorCode::NothingThere);
  EXPECT_EQ(refusal(sketch_of({line_stroke({{5, 5}})})), ErrorCode::NothingThere);
  EXPECT_EQ(refusal(sketch_of({line_stroke({{5, 5}, {5, 5}, {5, 5}})})), ErrorCode::NothingThere);
  EXPECT_EQ(refusal(sketch_of({line_stroke({{0, 0}, {900, 900}})})), ErrorCode::NothingThere);
  EXPECT_EQ(
      refusal(sketch_of({line_stroke({{0, 0}}), line_stroke({{9, 3}}), line_stroke({{4, 8}})})),
      ErrorCode::NothingThere);
}

TEST(Simplify, BadInputIsRefused) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  Sketch const good = sketch_of({circle_stroke({500, 500}, 300)});
  EXPECT_EQ(refusal(sketch_of({line_stroke({{nan, 0}, {1, 1}})})), ErrorCode::BadInput);
  EXPECT_EQ(refusal(sketch_of({line_stroke({{1e7, 0}, {1, 1}})})), ErrorCode::BadInput);
  Sketch lost = good;
  lost.strokes[0].group = 0;
  EXPECT_EQ(refusal(lost, {.parts = Parts::Groups}), ErrorCode::BadInput);
  EXPECT_EQ(refusal(good, {.gap_px = 0}), ErrorCode::BadOption);
  EXPECT_EQ(refusal(good, {.gap_px = nan}), ErrorCode::BadOption);
  EXPECT_EQ(refusal(good, {.smooth = 1.5}), ErrorCode::BadOption);
  EXPECT_EQ(refusal(good, {.outside = {{nan, 1}}}), ErrorCode::BadOption);
  EXPECT_EQ(refusal(good, {.inside = {{990, 990}}}), ErrorCode::BadOption);
  EXPECT_EQ(refusal(good, {.inside = {{1e300, 990}}}), ErrorCode::BadOption);
}

TEST(Simplify, CanBeCancelledAtEveryStage) {
  Sketch const sketch = sketch_of({circle_stroke({500, 500}, 300)});
  int stages = 0;
  ASSERT_TRUE(simplify(sketch, {}, {[&](std::string_view) { ++stages; }, {}}).has_value());
  EXPECT_GE(stages, 7);
  for (int stop = 1; stop <= stages; ++stop) {
    int seen = 0;
    auto const drawing =
        simplify(sketch, {}, {[&](std::string_view) { ++seen; }, [&] { return seen >= stop; }});
    ASSERT_FALSE(drawing.has_value());
    EXPECT_EQ(drawing.error().code, ErrorCode::Cancelled);
    EXPECT_EQ(seen, stop);
  }
}

TEST(Simplify, AnyRandomDrawingEndsValidOrRefused) {
  int closed = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    auto const drawing = simplify(random_sketch(seed));
    if (!drawing) {
      EXPECT_EQ(drawing.error().code, ErrorCode::NothingThere) << seed;
      continue;
    }
    ++closed;
    EXPECT_EQ(what_is_wrong(*drawing), "") << "seed " << seed;
  }
  EXPECT_GT(closed, 70);
}

}  // namespace
}  // namespace inkflate
