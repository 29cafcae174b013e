// SPDX-License-Identifier: Apache-2.0
#include "io/write_png.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "base/rng.h"
#include "io/read_picture.h"

namespace inkflate {
namespace {

/// Flat areas, ramps and noise, so that every filter and both packed and unpacked data occur.
Picture mixed_picture(Rng& rng, int width, int height) {
  Picture picture(width, height, {251, 248, 242, 255});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      auto const ramp = static_cast<std::uint8_t>(3 * x + y);
      if (x > y) picture.at(x, y) = {ramp, 7, static_cast<std::uint8_t>(y), 255};
      if (x + y > height) picture.at(x, y).a = static_cast<std::uint8_t>(rng.below(256));
    }
  }
  return picture;
}

TEST(WritePng, ReadingGivesThePictureBack) {
  Rng rng(11);
  for (int i = 0; i < 200; ++i) {
    auto const picture = mixed_picture(rng, 1 + rng.below(60), 1 + rng.below(60));
    auto const again = read_picture(write_png(picture));
    ASSERT_TRUE(again.has_value()) << again.error().message;
    ASSERT_EQ(*again, picture);
  }
}

TEST(WritePng, MasksAreGrey) {
  Mask mask(37, 19);
  for (int i = 0; i < 37 * 19; i += 3) mask.values[static_cast<std::size_t>(i)] = 255;
  auto const again = read_picture(write_png(mask));
  ASSERT_TRUE(again.has_value()) << again.error().message;
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    auto const value = mask.values[i];
    ASSERT_EQ(again->values[i], (Colour{value, value, value}));
  }
}

TEST(WritePng, BytesAreTheSameOnEveryMachine) {
  Rng rng(5);
  Hash hash;
  hash.add(std::span<std::byte const>(write_png(mixed_picture(rng, 64, 48))));
  EXPECT_EQ(hash.value(), 15684812618463936106U);
}

TEST(WritePng, FlatPicturesPackWell) {
  EXPECT_LT(write_png(Picture(1000, 1000, {251, 248, 242})).size(), 50000U);
}

}  // namespace
}  // namespace inkflate
