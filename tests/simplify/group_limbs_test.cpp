// SPDX-License-Identifier: Apache-2.0
#include "simplify/group_limbs.h"

#include <gtest/gtest.h>

#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// Five lines, far apart but where said otherwise.
Sketch five_lines() {
  return sketch_of({line_stroke({{0, 0}, {1000, 0}}), line_stroke({{0, 200}, {1000, 200}}),
                    line_stroke({{0, 400}, {1000, 400}}), line_stroke({{500, 406}, {500, 600}}),
                    line_stroke({{0, 800}, {1000, 800}})});
}

std::vector<Limb> limbs_of(GroupShapes const& group, std::vector<bool> const& is_faint = {
                                                         false, false, false, false, false}) {
  auto const sketch = five_lines();
  return group_limbs(sketch, group, is_faint, space_of(sketch));
}

Layer layer_of(std::vector<int> strokes, std::vector<int> details) {
  Layer layer;
  layer.strokes = std::move(strokes);
  layer.details = std::move(details);
  return layer;
}

TEST(GroupLimbs, ALayersStrokesAndDetailsAreALimb) {
  auto const limbs = limbs_of({{0, 1, 2, 4}, {layer_of({4, 1}, {0}), layer_of({2}, {})}, {}});
  ASSERT_EQ(limbs.size(), 2U);
  EXPECT_EQ(limbs[0].strokes, (std::vector<int>{0, 1, 4}));
  EXPECT_EQ(limbs[0].layer, 0);
  EXPECT_EQ(limbs[1].strokes, std::vector<int>{2});
  EXPECT_EQ(limbs[1].layer, 1);
}

TEST(GroupLimbs, StraysThatTouchAreOneLimbTheOthersForThemselves) {
  auto const limbs = limbs_of({{0, 1, 2, 3, 4}, {layer_of({0}, {})}, {1, 2, 3, 4}});
  ASSERT_EQ(limbs.size(), 4U);
  EXPECT_EQ(limbs[1].strokes, std::vector<int>{1});
  EXPECT_EQ(limbs[2].strokes, (std::vector<int>{2, 3}));
  EXPECT_EQ(limbs[2].layer, -1);
  EXPECT_EQ(limbs[3].strokes, std::vector<int>{4});
}

TEST(GroupLimbs, AStrayThatTouchesALayerGoesWithIt) {
  auto const limbs = limbs_of({{0, 2, 3}, {layer_of({0}, {}), layer_of({2}, {})}, {3}});
  ASSERT_EQ(limbs.size(), 2U);
  EXPECT_EQ(limbs[1].strokes, (std::vector<int>{2, 3}));
}

TEST(GroupLimbs, FaintStrokesTakeNoPart) {
  auto const limbs =
      limbs_of({{0, 1, 4}, {layer_of({0}, {1})}, {4}}, {false, true, false, false, true});
  ASSERT_EQ(limbs.size(), 1U);
  EXPECT_EQ(limbs[0].strokes, std::vector<int>{0});
}

}  // namespace
}  // namespace inkflate
