// SPDX-License-Identifier: Apache-2.0
#include "render/picture_sampler.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

constexpr Colour kClear = {0, 0, 0, 0};

TEST(PictureSampler, GivesPixelsAtTheirCentresAndMixesBetween) {
  Picture picture(2, 1, {200, 100, 0});
  picture.at(1, 0) = {100, 200, 0};
  PictureSampler const sampler(picture, 1);
  EXPECT_EQ(sampler({0.5, 0.5}), picture.at(0, 0));
  EXPECT_EQ(sampler({1.5, 0.5}), picture.at(1, 0));
  EXPECT_EQ(sampler({1, 0.5}), (Colour{150, 150, 0}));
  EXPECT_EQ(sampler({0, 0}), picture.at(0, 0));
}

TEST(PictureSampler, IsClearBeyondThePicture) {
  Picture const picture(3, 2, {9, 9, 9});
  PictureSampler const sampler(picture, 1);
  for (Vec2 const place : {Vec2{-0.1, 1}, {3.1, 1}, {1, -0.1}, {1, 2.1}}) {
    EXPECT_EQ(sampler(place), kClear);
  }
}

TEST(PictureSampler, ClearPixelsLendNoColour) {
  Picture picture(2, 1, {200, 100, 50});
  picture.at(1, 0) = kClear;
  EXPECT_EQ(PictureSampler(picture, 1)({1, 0.5}), (Colour{200, 100, 50, 128}));
  Picture const clear(1, 1, kClear);
  EXPECT_EQ(PictureSampler(clear, 1)({0.5, 0.5}), kClear);
}

TEST(PictureSampler, ManyPixelsAtOnceGiveTheirMean) {
  Picture picture(64, 64, {0, 0, 0});
  for (int y = 0; y < 64; ++y) {
    for (int x = y % 2; x < 64; x += 2) picture.at(x, y) = {200, 200, 200};
  }
  PictureSampler const sampler(picture, 16);
  EXPECT_EQ(sampler({20, 30}), (Colour{100, 100, 100}));
  EXPECT_EQ(PictureSampler(picture, 1e9)({63, 1}), (Colour{100, 100, 100}));
}

}  // namespace
}  // namespace inkflate
