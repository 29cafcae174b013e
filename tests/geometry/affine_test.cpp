// SPDX-License-Identifier: Apache-2.0
#include "geometry/affine.h"

#include <gtest/gtest.h>

#include "base/rng.h"

namespace inkflate {
namespace {

Affine random_map(Rng& rng) {
  return {rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3),
          rng.uniform(-3, 3), rng.uniform(-9, 9), rng.uniform(-9, 9)};
}

TEST(Affine, ProductIsInnerThenOuter) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    auto const outer = random_map(rng);
    auto const inner = random_map(rng);
    Vec2 const p = {rng.uniform(-9, 9), rng.uniform(-9, 9)};
    EXPECT_LT(distance((outer * inner)(p), outer(inner(p))), 1e-12);
    EXPECT_NEAR((outer * inner).determinant(), outer.determinant() * inner.determinant(), 1e-12);
  }
}

TEST(Affine, DefaultChangesNothing) {
  EXPECT_EQ(Affine{}({3, 4}), (Vec2{3, 4}));
  Affine const map = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(map * Affine{}, map);
  EXPECT_EQ(Affine{} * map, map);
}

TEST(Affine, MatrixIsOrderedAsInSvg) {
  EXPECT_EQ((Affine{1, 2, 3, 4, 5, 6}({10, 100})), (Vec2{315, 426}));
  EXPECT_EQ(Affine::translation({5, -2})({1, 1}), (Vec2{6, -1}));
  EXPECT_EQ(Affine::scaling(2, 3)({1, 1}), (Vec2{2, 3}));
}

TEST(Affine, MeanScaleIsTheRootOfTheAreaFactor) {
  EXPECT_DOUBLE_EQ(Affine::scaling(2, 8).mean_scale(), 4);
  EXPECT_DOUBLE_EQ(Affine::scaling(-3, 3).mean_scale(), 3);
  EXPECT_DOUBLE_EQ((Affine{0, 5, -5, 0, 7, 7}).mean_scale(), 5);
}

}  // namespace
}  // namespace inkflate
