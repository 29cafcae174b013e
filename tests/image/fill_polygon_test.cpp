// SPDX-License-Identifier: Apache-2.0
#include "image/fill_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rng.h"
#include "support/mask_text.h"

namespace inkflate {
namespace {

Contour rectangle(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

TEST(FillPolygon, TakesThePixelsWhoseCentresAreInside) {
  Mask mask(6, 4);
  std::vector<Contour> const contours = {rectangle(0.6, 0.4, 4.6, 2.6)};
  fill_polygon(contours, mask);
  EXPECT_EQ(text_of(mask), (std::vector<std::string>{".####.",  //
                                                     ".####.",  //
                                                     ".####.",  //
                                                     "......"}));
}

TEST(FillPolygon, ContoursOfNegativeAreaAreHoles) {
  Mask mask(6, 5);
  auto hole = rectangle(1, 1, 5, 4);
  std::reverse(hole.begin(), hole.end());
  std::vector<Contour> const contours = {rectangle(0, 0, 6, 5), hole, rectangle(2, 2, 4, 3)};
  fill_polygon(contours, mask);
  EXPECT_EQ(text_of(mask), (std::vector<std::string>{"######",  //
                                                     "#....#",  //
                                                     "#.##.#",  //
                                                     "#....#",  //
                                                     "######"}));
}

TEST(FillPolygon, AgreesWithTheWindingNumberOfAnyPolygon) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    Contour contour;
    for (int n = 0; n < 7; ++n) contour.push_back({rng.uniform(-8, 28), rng.uniform(-8, 28)});
    Mask mask(20, 20);
    fill_polygon(std::vector<Contour>{contour}, mask);
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        EXPECT_EQ(mask.at(x, y) != 0, contains(contour, {x + 0.5, y + 0.5}));
      }
    }
  }
}

TEST(FillPolygon, NeighboursShareNoPixelAndLeaveNone) {
  Rng rng(2);
  for (int i = 0; i < 200; ++i) {
    // Corners on centres, so that edges run through pixel centres.
    Vec2 const middle = {2.5 + rng.below(6), 2.5 + rng.below(6)};
    Vec2 const corners[4] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    std::vector<int> times(100, 0);
    for (int n = 0; n < 4; ++n) {
      Mask mask(10, 10);
      fill_polygon(std::vector<Contour>{{corners[n], corners[(n + 1) % 4], middle}}, mask);
      for (int pixel = 0; pixel < 100; ++pixel) times[pixel] += mask.values[pixel] != 0 ? 1 : 0;
    }
    EXPECT_EQ(times, std::vector<int>(100, 1));
  }
}

TEST(FillPolygon, FillsTheMaskThatLiesInsideAHugePolygon) {
  Mask mask(4, 4);
  fill_polygon(std::vector<Contour>{rectangle(-1e6, -1e6, 1e6, 1e6)}, mask);
  EXPECT_EQ(mask, Mask(4, 4, 255));
}

TEST(FillPolygon, LessThanATriangleFillsNothing) {
  Mask mask(4, 4);
  fill_polygon(std::vector<Contour>{{}, {{1, 1}}, {{0, 0}, {4, 4}}}, mask);
  EXPECT_EQ(mask, Mask(4, 4));
}

}  // namespace
}  // namespace inkflate
