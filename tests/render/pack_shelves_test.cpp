// SPDX-License-Identifier: Apache-2.0
#include "render/pack_shelves.h"

#include <gtest/gtest.h>

#include "base/rng.h"

namespace inkflate {
namespace {

bool overlap(PixelBox const& a, PixelBox const& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

std::vector<PixelSize> random_sizes(int count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<PixelSize> sizes;
  for (int i = 0; i < count; ++i) {
    sizes.push_back({static_cast<int>(rng.uniform(1, 200)), static_cast<int>(rng.uniform(1, 300))});
  }
  return sizes;
}

TEST(PackShelves, BoxesHaveTheirSizesLieInsideAndDoNotOverlap) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto const sizes = random_sizes(1 + static_cast<int>(seed) * 3, seed);
    auto const shelves = pack_shelves(sizes);
    ASSERT_EQ(shelves.boxes.size(), sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      auto const& box = shelves.boxes[i];
      EXPECT_EQ(box.width, sizes[i].width);
      EXPECT_EQ(box.height, sizes[i].height);
      EXPECT_TRUE(box.left >= 0 && box.left + box.width <= shelves.width);
      EXPECT_TRUE(box.top >= 0 && box.top + box.height <= shelves.height);
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(box, shelves.boxes[k]));
    }
  }
}

TEST(PackShelves, MostOfThePictureIsUsed) {
  auto const sizes = random_sizes(60, 5);
  auto const shelves = pack_shelves(sizes);
  double used = 0;
  for (auto const size : sizes) used += static_cast<double>(size.width) * size.height;
  EXPECT_GT(used, 0.65 * shelves.width * shelves.height);
}

TEST(PackShelves, NothingNeedsNoPlace) {
  auto const shelves = pack_shelves({});
  EXPECT_EQ(shelves.width, 0);
  EXPECT_EQ(shelves.height, 0);
}

}  // namespace
}  // namespace inkflate
