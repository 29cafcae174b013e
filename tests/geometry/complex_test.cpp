// SPDX-License-Identifier: Apache-2.0
#include "geometry/complex.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

TEST(Complex, ProductTurnsFromXTowardsYAndScales) {
  EXPECT_EQ(product({3, 1}, {0, 1}), perpendicular({3, 1}));
  EXPECT_EQ(product({3, 1}, {2, 0}), (Vec2{6, 2}));
}

TEST(Complex, ConjugateTurnsBack) {
  Vec2 const turn = {0.6, 0.8};
  Vec2 const back = product(product({3, 1}, turn), conjugate(turn));
  EXPECT_NEAR(back.x, 3, 1e-15);
  EXPECT_NEAR(back.y, 1, 1e-15);
}

}  // namespace
}  // namespace inkflate
