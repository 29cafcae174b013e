// SPDX-License-Identifier: Apache-2.0
#include "geometry/segment.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

TEST(Segment, NearestPlaceIsAtTheFootOrAtAnEnd) {
  EXPECT_EQ(nearest_on_segment({1, 5}, {0, 0}, {4, 0}), (Vec2{1, 0}));
  EXPECT_EQ(nearest_on_segment({-1, 5}, {0, 0}, {4, 0}), (Vec2{0, 0}));
  EXPECT_EQ(nearest_on_segment({9, -5}, {0, 0}, {4, 0}), (Vec2{4, 0}));
}

TEST(Segment, ShareRunsFromOneEndToTheOther) {
  EXPECT_EQ(share_along({1, 5}, {0, 0}, {4, 0}), 0.25);
  EXPECT_EQ(share_along({1, 5}, {4, 0}, {0, 0}), 0.75);
}

TEST(Segment, WithoutLengthIsItsPoint) {
  EXPECT_EQ(share_along({1, 5}, {2, 2}, {2, 2}), 0);
  EXPECT_EQ(nearest_on_segment({1, 5}, {2, 2}, {2, 2}), (Vec2{2, 2}));
}

}  // namespace
}  // namespace inkflate
