// SPDX-License-Identifier: Apache-2.0
#include "image/rasterise_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "support/mask_text.h"

namespace inkflate {
namespace {

int count_of(Mask const& mask) {
  return static_cast<int>(std::count(mask.values.begin(), mask.values.end(), 255));
}

Vec2 random_point(Rng& rng, double low, double high) {
  return {rng.uniform(low, high), rng.uniform(low, high)};
}

TEST(RasteriseLine, DrawsTheTextbookLine) {
  Mask mask(8, 4);
  rasterise_line({0.5, 0.5}, {7.5, 3.5}, mask);
  EXPECT_EQ(text_of(mask), (std::vector<std::string>{"##......",  //
                                                     "..##....",  //
                                                     "....##..",  //
                                                     "......##"}));
}

TEST(RasteriseLine, TakesOnePixelPerStepWithinHalfAPixelOfTheLine) {
  Rng rng(1);
  for (int i = 0; i < 300; ++i) {
    Mask mask(40, 40);
    auto const from = random_point(rng, 0, 40);
    auto const to = random_point(rng, 0, 40);
    rasterise_line(from, to, mask);
    double const x0 = std::floor(from.x);
    double const y0 = std::floor(from.y);
    double const dx = std::floor(to.x) - x0;
    double const dy = std::floor(to.y) - y0;
    double const longer = std::max(std::fabs(dx), std::fabs(dy));
    EXPECT_EQ(count_of(mask), longer + 1);
    for (int step = 0; step <= longer; ++step) {
      double const t = longer > 0 ? step / longer : 0;
      bool hit = false;
      for (double const up : {-0.5, 0.5}) {  // a tie may go either way
        hit = hit || mask.at(static_cast<int>(std::floor(x0 + t * dx + 0.5 + up * 1e-9)),
                             static_cast<int>(std::floor(y0 + t * dy + 0.5 + up * 1e-9))) != 0;
      }
      EXPECT_TRUE(hit);
    }
  }
}

TEST(RasteriseLine, ClippedIsTheSameAsCutOutOfALargerMask) {
  Rng rng(2);
  for (int i = 0; i < 300; ++i) {
    Vec2 const shift = {30, 30};
    auto const from = random_point(rng, -30, 50);
    auto const to = random_point(rng, -30, 50);
    Mask small(20, 17);
    Mask large(80, 80);
    rasterise_line(from, to, small);
    rasterise_line(from + shift, to + shift, large);
    for (int y = 0; y < small.height; ++y) {
      for (int x = 0; x < small.width; ++x) {
        EXPECT_EQ(small.at(x, y), large.at(x + 30, y + 30));
      }
    }
  }
}

TEST(RasteriseLine, CrossesTheMaskFromVeryFarAway) {
  Mask mask(9, 9);
  rasterise_line({-1e6, -1e6}, {1e6, 1e6}, mask);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(mask.at(i, i), 255);
  EXPECT_EQ(count_of(mask), 9);
}

TEST(RasteriseLine, LeavesAnEmptyMaskAlone) {
  Mask mask;
  rasterise_line({-5, 0}, {5, 0}, mask);
  EXPECT_TRUE(mask.values.empty());
}

TEST(RasteriseLine, ASinglePointIsAPixel) {
  Mask mask(3, 3);
  std::vector<Vec2> const dot = {{1.9, 1.1}};
  rasterise_polyline(dot, mask);
  EXPECT_EQ(text_of(mask), (std::vector<std::string>{"...", ".#.", "..."}));
}

}  // namespace
}  // namespace inkflate
