// SPDX-License-Identifier: Apache-2.0
#include "simplify/cut_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// A half circle of radius 500 about (500, 0), open above. Its chord costs 17 * 1000, its ink pays 3 * 1571.
Sketch bowl() { return sketch_of({arc_stroke({500, 0}, 500, 500, 0, M_PI)}); }

CutParts cut_of(Sketch const& sketch, std::vector<Chord> const& chords) {
  auto samples = samples_of(sketch, kCutSpacingPx);
  for (int i = 0; i < std::ssize(chords); ++i) {
    append_chord(
        {space_of(sketch).work_point(chords[i].from), space_of(sketch).work_point(chords[i].to)},
        static_cast<int>(std::ssize(sketch.strokes)) + i, samples);
  }
  return *cut_parts(sketch, std::move(samples), space_of(sketch), {}, {});
}

/// Of the largest part's outer rim, work px squared.
double area(CutParts const& cut) {
  return signed_area(positions(cut.parts.at(0).at(0), cut.cells.samples));
}

TEST(CutParts, AChordClosesWhatPaperLeavesOpen) {
  EXPECT_TRUE(cut_of(bowl(), {}).parts.empty());
  auto const cut = cut_of(bowl(), {{{0, 0}, {1000, 0}}});
  ASSERT_EQ(cut.parts.size(), 1U);
  EXPECT_NEAR(area(cut), M_PI * 500 * 500 / 2, 3000);
}

TEST(CutParts, AlongAChordTheRimIsOneClosing) {
  auto const cut = cut_of(bowl(), {{{0, 0}, {1000, 0}}});
  auto const& rim = cut.parts.at(0).at(0);
  EXPECT_EQ(std::count_if(rim.begin(), rim.end(),
                          [](RimPoint const& p) { return p.to_next == RunKind::Closing; }),
            1);
  for (auto const& point : rim) EXPECT_FALSE(cut.cells.samples.is_chord(point.sample));
}

TEST(CutParts, AChordAloneEnclosesNothing) {
  // Ink on one side of it, but none around anything.
  auto const sketch = sketch_of({line_stroke({{0, 0}, {1000, 0}})});
  EXPECT_TRUE(cut_of(sketch, {{{0, 20}, {1000, 20}}, {{0, 0}, {0, 20}}}).parts.empty());
}

TEST(CutParts, AChordChangesNothingWhereItEnclosesNothing) {
  auto const sketch =
      sketch_of({circle_stroke({500, 500}, 400), line_stroke({{950, 0}, {999, 0}})});
  auto const without = cut_of(sketch, {});
  auto const with = cut_of(sketch, {{{900, 500}, {975, 0}}});
  ASSERT_EQ(with.parts.size(), 1U);
  EXPECT_NEAR(area(with), area(without), 20);  // but where the chord sets out
}

TEST(CutParts, WhatIsFittedIsClosedAlongTheChord) {
  auto const sketch = bowl();
  auto const layers = fit_parts(cut_of(sketch, {{{0, 0}, {1000, 0}}}), space_of(sketch), 0.5, {});
  ASSERT_TRUE(layers.has_value());
  ASSERT_EQ(layers->size(), 1U);
  double closing_px = 0;
  for (auto const& run : runs(layers->at(0).outlines[0], 0.1))
    closing_px += run.kind == RunKind::Closing ? length(run.points) : 0;
  EXPECT_NEAR(closing_px, 1000, 5);
  EXPECT_EQ(what_is_wrong({sketch, *layers, {0}}), "");
}

}  // namespace
}  // namespace inkflate
