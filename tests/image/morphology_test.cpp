// SPDX-License-Identifier: Apache-2.0
#include "image/morphology.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "support/mask_text.h"

namespace inkflate {
namespace {

Mask random_mask(Rng& rng, int one_in) {
  Mask mask(1 + rng.below(20), 1 + rng.below(20));
  for (auto& value : mask.values) value = rng.below(one_in) == 0 ? 0 : 255;
  return mask;
}

/// How many of the 9 pixels round about are set; those outside are not.
int set_around(Mask const& mask, int x, int y) {
  int count = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (mask.contains(x + dx, y + dy) && mask.at(x + dx, y + dy) != 0) ++count;
    }
  }
  return count;
}

TEST(Morphology, ErosionKeepsPixelsInTheMiddleOfNineAndDilationSpreadsToNine) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    auto const mask = random_mask(rng, 2 + rng.below(8));
    auto const eroded = erode_3x3(mask);
    auto const dilated = dilate_3x3(mask);
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        EXPECT_EQ(eroded.at(x, y), set_around(mask, x, y) == 9 ? 255 : 0);
        EXPECT_EQ(dilated.at(x, y), set_around(mask, x, y) > 0 ? 255 : 0);
      }
    }
  }
}

TEST(Morphology, OpeningTwiceIsOpeningOnce) {
  Rng rng(2);
  for (int i = 0; i < 200; ++i) {
    auto const once = dilate_3x3(erode_3x3(random_mask(rng, 9)));
    EXPECT_EQ(dilate_3x3(erode_3x3(once)), once);
  }
}

TEST(Morphology, OpeningTakesThinPartsOffAndKeepsTheRest) {
  auto const opened = dilate_3x3(erode_3x3(mask_of({"........",  //
                                                    ".####...",  //
                                                    ".#######",  //
                                                    ".####...",  //
                                                    "........"})));
  EXPECT_EQ(text_of(opened), (std::vector<std::string>{"........",  //
                                                       ".####...",  //
                                                       ".####...",  //
                                                       ".####...",  //
                                                       "........"}));
}

TEST(Morphology, NothingComesOfNothing) { EXPECT_EQ(dilate_3x3(erode_3x3(Mask())), Mask()); }

}  // namespace
}  // namespace inkflate
