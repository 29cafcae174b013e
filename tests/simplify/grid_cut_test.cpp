// SPDX-License-Identifier: Apache-2.0
#include "simplify/grid_cut.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "image/rasterise_line.h"
#include "support/mask_text.h"

namespace inkflate {
namespace {

constexpr int kMargin = 3;

/// The outline of a square of `side` pixels, with the `gap` pixels in the middle of its top side missing.
Mask square_with_gap(int side, int gap) {
  Mask mask(side + 2 * kMargin, side + 2 * kMargin);
  int const first = kMargin;
  int const last = kMargin + side - 1;
  for (int i = first; i <= last; ++i) {
    mask.at(i, first) = mask.at(i, last) = mask.at(first, i) = mask.at(last, i) = 255;
  }
  int const start = first + (side - gap) / 2;
  for (int x = start; x < start + gap; ++x) mask.at(x, first) = 0;
  return mask;
}

bool is_filled(Mask const& shape) { return shape.at(shape.width / 2, shape.height / 2) != 0; }

TEST(GridCut, LabelsTheThesisExample) {
  // Figure 3.14: the rim is 0, strokes are 1, and nothing near this stroke is enclosed.
  auto const ink = mask_of({".......",  //
                            ".#.....",  //
                            "..##...",  //
                            "...##..",  //
                            ".......",  //
                            "......."});
  EXPECT_EQ(text_of(cut_grid(ink, {})), text_of(ink));
}

TEST(GridCut, ASquareWithAGapIsFilledAsTheWeightsBalance) {
  // Open, the 4 (side - 2) - gap ink pixels of the inner rim and the gap's two ends cost 3 each; closed, the gap's
  // pixels cost 17 each. So it is closed when 20 gap < 12 side - 18; equal they cannot be.
  for (int side = 3; side <= 24; ++side) {
    for (int gap = 0; gap <= side - 2; ++gap) {
      auto const shape = cut_grid(square_with_gap(side, gap), {});
      EXPECT_EQ(is_filled(shape), gap == 0 || 10 * gap < 6 * side - 9) << side << ' ' << gap;
    }
  }
}

TEST(GridCut, TheBalanceFollowsTheWeights) {
  for (int gap = 1; gap <= 14; ++gap) {
    // ink (4 (16 - 2) - gap + 2) against paper gap
    EXPECT_EQ(is_filled(cut_grid(square_with_gap(16, gap), {2, 9, 10000})),
              9 * gap < 2 * (58 - gap));
  }
}

TEST(GridCut, ScribblesInsideAndNoiseOutsideDoNotDisturb) {
  auto ink = square_with_gap(20, 4);
  auto const clean = cut_grid(ink, {});
  ASSERT_TRUE(is_filled(clean));
  rasterise_line({8, 9}, {17, 18}, ink);
  rasterise_line({15, 9}, {12, 18}, ink);
  EXPECT_EQ(cut_grid(ink, {}), clean);
  ink.at(1, 4) = ink.at(24, 24) = ink.at(10, 1) = 255;
  auto noisy = clean;
  noisy.at(1, 4) = noisy.at(24, 24) = noisy.at(10, 1) = 255;
  EXPECT_EQ(cut_grid(ink, {}), noisy);
}

TEST(GridCut, ClosingsRunAlongTheAxes) {
  // A square without its upper left corner: the straight way across would be 8 * 1.41 long; on the grid every
  // way down and to the left is 16 long, and of equals the cut takes the one with the least inside.
  int const gap = 8;
  auto ink = square_with_gap(40, 0);
  for (int i = 0; i < gap; ++i) ink.at(kMargin + i, kMargin) = ink.at(kMargin, kMargin + i) = 0;
  auto const shape = cut_grid(ink, {});
  ASSERT_TRUE(is_filled(shape));
  for (int y = 0; y < gap; ++y) {
    for (int x = 0; x < gap; ++x) EXPECT_EQ(shape.at(kMargin + x, kMargin + y), 0);
  }
  EXPECT_EQ(shape.at(kMargin + gap, kMargin + gap), 255);
}

TEST(GridCut, ADiagonalGapCountsAsLongAsItsWayAlongTheAxes) {
  // The same gap of 12 px: at a corner it is 12 + 12 px wide on the grid, in a side 12.
  int const side = 24;
  auto corner = square_with_gap(side, 0);
  for (int i = 0; i < 12; ++i)
    corner.at(kMargin + i, kMargin) = corner.at(kMargin, kMargin + i) = 0;
  EXPECT_FALSE(is_filled(cut_grid(corner, {})));
  EXPECT_TRUE(is_filled(cut_grid(square_with_gap(side, 12), {})));
}

TEST(GridCut, TheRimIsOutsideEvenUnderInk) {
  Mask const ink(5, 4, 255);
  EXPECT_EQ(text_of(cut_grid(ink, {})), (std::vector<std::string>{".....",  //
                                                                  ".###.",  //
                                                                  ".###.",  //
                                                                  "....."}));
}

TEST(GridCut, AMarkOutsideOpensWhatWouldBeClosed) {
  auto const ink = square_with_gap(20, 4);
  std::vector<Vec2> const middle = {{kMargin + 10.0, kMargin + 10.0}};
  ASSERT_TRUE(is_filled(cut_grid(ink, {})));
  EXPECT_EQ(text_of(cut_grid(ink, {}, middle)), text_of(ink));
}

TEST(GridCut, AMarkInsideClosesWhatWouldBeOpen) {
  auto const ink = square_with_gap(20, 14);
  std::vector<Vec2> const middle = {{kMargin + 10.0, kMargin + 10.0}};
  ASSERT_FALSE(is_filled(cut_grid(ink, {})));
  EXPECT_EQ(text_of(cut_grid(ink, {}, {}, middle)), text_of(cut_grid(square_with_gap(20, 0), {})));
}

TEST(GridCut, NothingInAnEmptyPicture) {
  EXPECT_EQ(cut_grid(Mask(), {}), Mask());
  EXPECT_EQ(cut_grid(Mask(7, 3), {}), Mask(7, 3));
}

}  // namespace
}  // namespace inkflate
