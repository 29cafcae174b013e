// SPDX-License-Identifier: Apache-2.0
#include "geometry/rect.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

TEST(Rect, IsMadeEmptyAndWithoutSize) {
  Rect const box;
  EXPECT_TRUE(box.is_empty());
  EXPECT_EQ(box.width(), 0);
  EXPECT_EQ(box.height(), 0);
  EXPECT_EQ(box.longer_side(), 0);
}

TEST(Rect, OnePointMakesItAPoint) {
  Rect box;
  box.include({-3, 8});
  EXPECT_FALSE(box.is_empty());
  EXPECT_EQ(box.width(), 0);
  EXPECT_EQ(box.centre(), (Vec2{-3, 8}));
}

TEST(Rect, GrowsToHoldAllPoints) {
  Rect box;
  for (Vec2 const p : {Vec2{1, 5}, {-2, 9}, {4, 6}}) box.include(p);
  EXPECT_EQ(box, (Rect{{-2, 5}, {4, 9}}));
  EXPECT_EQ(box.longer_side(), 6);
  EXPECT_EQ(box.centre(), (Vec2{1, 7}));
}

}  // namespace
}  // namespace inkflate
