// SPDX-License-Identifier: Apache-2.0
#include "simplify/grid_outline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rng.h"
#include "image/fill_polygon.h"
#include "image/morphology.h"
#include "image/trace_contour.h"

namespace inkflate {
namespace {

Contour square_loop(int side) {
  Mask mask(side, side, 255);
  return trace_contours(mask)[0].outer;
}

bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return cross(b - a, c - a) * cross(b - a, d - a) <= 0 &&
         cross(d - c, a - c) * cross(d - c, b - c) <= 0 &&
         std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

/// Closed, without repeated corners, and no two edges meet but neighbours at their corner.
void expect_simple(Outline const& outline) {
  auto const& pieces = outline.pieces;
  int const count = static_cast<int>(std::ssize(pieces));
  ASSERT_GE(count, 3);
  for (int i = 0; i < count; ++i) {
    auto const& curve = pieces[i].curve;
    auto const& next = pieces[(i + 1) % count].curve;
    EXPECT_EQ(curve.end(), next.start());
    EXPECT_FALSE(cross(curve.end() - curve.start(), next.end() - next.start()) == 0 &&
                 dot(curve.end() - curve.start(), next.end() - next.start()) < 0);
    for (int j = i + 2; j < count; ++j) {
      if (i == 0 && j == count - 1) continue;
      auto const& other = pieces[j].curve;
      EXPECT_FALSE(segments_cross(curve.start(), curve.end(), other.start(), other.end()));
    }
  }
}

TEST(GridOutline, LinesAreLongerThanTheLeastButTheLast) {
  std::vector<Contour> const loops = {square_loop(11)};  // 40 px round
  auto const outlines = outlines_of(loops, Mask(11, 11), 3);
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_EQ(outlines[0].pieces.size(), 10U);
  for (auto const& piece : outlines[0].pieces) {
    EXPECT_EQ(piece.kind, RunKind::Ink);
    EXPECT_LE(distance(piece.curve.start(), piece.curve.end()), 4);
  }
  EXPECT_EQ(outlines_of(loops, Mask(11, 11), 8.5)[0].pieces.size(), 5U);
  EXPECT_EQ(outlines_of(loops, Mask(11, 11), 0)[0].pieces.size(), 40U);
}

TEST(GridOutline, OnePixelOnAHelpLineMakesALineAHelpLine) {
  std::vector<Contour> const loops = {square_loop(11)};
  Mask help_lines(11, 11);
  help_lines.at(6, 0) = 255;
  auto const outlines = outlines_of(loops, help_lines, 3);
  for (auto const& piece : outlines[0].pieces) {
    bool const holds_it = piece.curve.start() == Vec2{4.5, 0.5};
    EXPECT_EQ(piece.kind, holds_it ? RunKind::HelpLine : RunKind::Ink);
  }
}

TEST(GridOutline, OutlinesAreSimpleHoweverLongTheLines) {
  Rng rng(1);
  int loop_count = 0;
  for (int i = 0; i < 150; ++i) {
    Mask mask(30, 26);
    for (auto& value : mask.values) value = rng.below(16) == 0 ? 255 : 0;
    mask = dilate_3x3(mask);
    double const min_length_px = rng.below(12);
    for (auto const& piece : trace_contours(mask)) {
      for (auto const& loop : simple_loops(piece.outer)) {
        auto const outlines = outlines_of(std::vector<Contour>{loop}, mask, min_length_px);
        expect_simple(outlines[0]);
        ++loop_count;
      }
    }
  }
  EXPECT_GT(loop_count, 150);
}

TEST(GridOutline, NoOutlinesOfNoLoops) { EXPECT_TRUE(outlines_of({}, Mask(), 3).empty()); }

}  // namespace
}  // namespace inkflate
