// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.h"
#include "image/components.h"
#include "image/distance.h"
#include "image/filter.h"
#include "image/otsu.h"
#include "image/thin.h"

namespace inkflate {
namespace {

/// Random blobs: noise of the given density, smoothed now and then so that thick and thin areas occur.
Mask random_mask(Rng& rng, int width, int height) {
  Mask mask(width, height);
  double const density = rng.uniform(0.1, 0.9);
  for (auto& value : mask.values) value = rng.uniform() < density ? 255 : 0;
  if (rng.below(2) == 0) {
    auto const soft = soften(soften(mask));
    auto const level = static_cast<std::uint8_t>(255 * density);
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
      mask.values[i] = soft.values[i] >= level ? 255 : 0;
    }
  }
  return mask;
}

int area_count(Mask const& mask, Neighbours neighbours) {
  return static_cast<int>(connected_components(mask, neighbours).areas.size());
}

/// The complement with a frame of one pixel, so that all background that reaches the border is one area.
Mask background(Mask const& mask) {
  Mask result(mask.width + 2, mask.height + 2, 255);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) != 0) result.at(x + 1, y + 1) = 0;
    }
  }
  return result;
}

double brute_force_squared_distance(Mask const& mask, int x, int y) {
  double best = 1e300;
  for (int j = 0; j < mask.height; ++j) {
    for (int i = 0; i < mask.width; ++i) {
      if (mask.at(i, j) != 0) continue;
      best = std::min(best, static_cast<double>((i - x) * (i - x) + (j - y) * (j - y)));
    }
  }
  return best;
}

TEST(Distance, EqualsBruteForce) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    auto mask = random_mask(rng, 1 + rng.below(20), 1 + rng.below(20));
    mask.values[static_cast<std::size_t>(rng.below(static_cast<int>(mask.values.size())))] = 0;
    auto const distances = squared_distance_to_zero(mask);
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        ASSERT_EQ(distances.at(x, y), brute_force_squared_distance(mask, x, y));
      }
    }
  }
}

TEST(Distance, IsFarWhereNothingIsZero) {
  for (double const value : squared_distance_to_zero(Mask(9, 5, 255)).values) {
    EXPECT_GT(value, 2.0 * 16384 * 16384);
  }
}

TEST(Thin, KeepsAreasAndHoles) {
  Rng rng(2);
  for (int i = 0; i < 300; ++i) {
    auto const mask = random_mask(rng, 1 + rng.below(40), 1 + rng.below(40));
    auto const lines = thin(mask);
    ASSERT_EQ(area_count(lines, Neighbours::Eight), area_count(mask, Neighbours::Eight));
    ASSERT_EQ(area_count(background(lines), Neighbours::Four),
              area_count(background(mask), Neighbours::Four));
  }
}

TEST(Thin, IsThinAndInsideAndStaysSo) {
  Rng rng(3);
  for (int i = 0; i < 100; ++i) {
    auto const mask = random_mask(rng, 40, 40);
    auto const lines = thin(mask);
    EXPECT_EQ(thin(lines), lines);
    for (std::size_t k = 0; k < mask.values.size(); ++k) {
      ASSERT_LE(lines.values[k], mask.values[k]);
    }
  }
}

TEST(Thin, AThickBarBecomesItsMiddle) {
  Mask mask(60, 30);
  for (int y = 10; y < 19; ++y) {
    for (int x = 5; x < 55; ++x) mask.at(x, y) = 255;
  }
  auto const lines = thin(mask);
  for (int x = 15; x < 45; ++x) {
    for (int y = 0; y < 30; ++y) EXPECT_EQ(lines.at(x, y), y == 14 ? 255 : 0);
  }
}

TEST(Components, CornersJoinOnlyWhenAsked) {
  Mask mask(3, 3);
  mask.at(0, 0) = mask.at(1, 1) = mask.at(2, 2) = 255;
  EXPECT_EQ(area_count(mask, Neighbours::Eight), 1);
  EXPECT_EQ(area_count(mask, Neighbours::Four), 3);
  EXPECT_EQ(without_specks(mask, 3), mask);
  EXPECT_EQ(without_specks(mask, 4), Mask(3, 3));
}

TEST(Filter, ShrinkingKeepsTheMean) {
  Rng rng(4);
  for (int i = 0; i < 100; ++i) {
    Picture picture(1 + rng.below(50), 1 + rng.below(50));
    double sum = 0;
    for (auto& pixel : picture.values) {
      pixel = {static_cast<std::uint8_t>(rng.below(256)), 0, 0, 255};
      sum += pixel.r;
    }
    auto const small = shrink(picture, 1 + rng.below(picture.width), 1 + rng.below(picture.height));
    double small_sum = 0;
    for (auto const pixel : small.values) small_sum += pixel.r;
    auto const mean = sum / static_cast<double>(picture.values.size());
    EXPECT_NEAR(small_sum / static_cast<double>(small.values.size()), mean, 0.5);
  }
}

TEST(Filter, ShrinkingBySizeOneKeepsThePicture) {
  Picture picture(7, 3, {1, 2, 3, 4});
  picture.at(3, 1) = {200, 100, 50, 25};
  EXPECT_EQ(shrink(picture, 7, 3), picture);
}

TEST(Filter, ExtremesOfAWindowEqualBruteForce) {
  Rng rng(5);
  for (int i = 0; i < 100; ++i) {
    Mask mask(1 + rng.below(15), 1 + rng.below(15));
    for (auto& value : mask.values) value = static_cast<std::uint8_t>(rng.below(256));
    int const radius = rng.below(4);
    auto const most = local_maximum(mask, radius);
    auto const least = local_minimum(mask, radius);
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x) {
        int high = 0;
        int low = 255;
        for (int v = std::max(0, y - radius); v <= std::min(mask.height - 1, y + radius); ++v) {
          for (int u = std::max(0, x - radius); u <= std::min(mask.width - 1, x + radius); ++u) {
            high = std::max<int>(high, mask.at(u, v));
            low = std::min<int>(low, mask.at(u, v));
          }
        }
        ASSERT_EQ(most.at(x, y), high);
        ASSERT_EQ(least.at(x, y), low);
      }
    }
  }
}

TEST(Filter, BoxMeanOfARampIsTheRampAwayFromTheBorder) {
  Grid2<double> ramp(30, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 30; ++x) ramp.at(x, y) = 2 * x + 5 * y;
  }
  auto const mean = box_mean(ramp, 3);
  for (int y = 3; y < 17; ++y) {
    for (int x = 3; x < 27; ++x) EXPECT_NEAR(mean.at(x, y), ramp.at(x, y), 1e-9);
  }
}

TEST(Filter, PaperShowsThroughClearPixels) {
  Picture picture(3, 1, {10, 20, 30, 0});
  picture.at(1, 0).a = 255;
  picture.at(2, 0) = {0, 100, 255, 128};
  auto const flat = over_white(picture);
  EXPECT_EQ(flat.at(0, 0), (Colour{255, 255, 255}));
  EXPECT_EQ(flat.at(1, 0), (Colour{10, 20, 30}));
  EXPECT_EQ(flat.at(2, 0), (Colour{127, 177, 255}));
}

TEST(Otsu, PartsTwoHeaps) {
  Mask mask(100, 1, 20);
  for (int x = 60; x < 100; ++x) mask.at(x, 0) = 200;
  auto const counts = histogram(mask);
  EXPECT_NEAR(otsu_threshold(counts), 110, 1);
  EXPECT_EQ(quantile(counts, 0.5), 20);
  EXPECT_EQ(quantile(counts, 0.61), 200);
}

TEST(Otsu, OneHeapHasNoThreshold) { EXPECT_EQ(otsu_threshold(histogram(Mask(10, 10, 80))), 0); }

TEST(Otsu, EqualsBruteForce) {
  Rng rng(6);
  for (int i = 0; i < 100; ++i) {
    Mask mask(40, 1);
    for (auto& value : mask.values) value = static_cast<std::uint8_t>(rng.below(256));
    auto const spread = [&](double threshold) {
      double count[2] = {0, 0};
      double sum[2] = {0, 0};
      for (auto const value : mask.values) {
        count[value >= threshold ? 1 : 0] += 1;
        sum[value >= threshold ? 1 : 0] += value;
      }
      if (count[0] == 0 || count[1] == 0) return 0.0;
      double const difference = sum[0] / count[0] - sum[1] / count[1];
      return count[0] * count[1] * difference * difference;
    };
    double best = 0;
    for (int threshold = 0; threshold < 256; ++threshold) best = std::max(best, spread(threshold));
    EXPECT_NEAR(spread(otsu_threshold(histogram(mask))), best, 1e-9 * best);
  }
}

}  // namespace
}  // namespace inkflate
