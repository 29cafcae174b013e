// SPDX-License-Identifier: Apache-2.0
#include "simplify/layer_area.h"

#include <gtest/gtest.h>

#include "geometry/cubic.h"

namespace inkflate {
namespace {

/// A square of 100 canvas px in a space in which these are 200 work px, from (12, 12) to (212, 212).
LayerArea square() {
  WorkSpace space;
  space.to_work = 2;
  space.to_canvas = 0.5;
  Contour const corners = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  Layer layer;
  layer.outlines.emplace_back();
  for (std::size_t i = 0; i < 4; ++i)
    layer.outlines[0].pieces.push_back(
        {line_cubic(corners[i], corners[(i + 1) % 4]), RunKind::Ink});
  return LayerArea(layer, space);
}

TEST(LayerArea, HoldsWhatTheOutlineEncloses) {
  auto const area = square();
  EXPECT_NEAR(signed_area(area.contour()), 200 * 200, 1e-6);
  EXPECT_TRUE(area.holds({20, 200}));
  EXPECT_FALSE(area.holds({220, 100}));
  EXPECT_FALSE(area.holds({5, 100}));
}

TEST(LayerArea, KnowsWhatIsNearItsRim) {
  auto const area = square();
  EXPECT_TRUE(area.is_at_rim({220, 100}, 10));
  EXPECT_TRUE(area.is_at_rim({204, 100}, 10));
  EXPECT_FALSE(area.is_at_rim({225, 100}, 10));
  EXPECT_FALSE(area.is_at_rim({100, 100}, 80));
}

TEST(LayerArea, CoversItsAreaAndABandAroundIt) {
  auto const area = square();
  EXPECT_TRUE(area.covers({100, 100}, 1));
  EXPECT_TRUE(area.covers({220, 100}, 10));
  EXPECT_FALSE(area.covers({225, 100}, 10));
}

}  // namespace
}  // namespace inkflate
