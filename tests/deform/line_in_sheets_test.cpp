// SPDX-License-Identifier: Apache-2.0
#include "deform/line_in_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "deform/body_mesh.h"
#include "support/bend_shapes.h"

namespace inkflate {
namespace {

using support::folded_limb_corners;
using support::polygon_outline;

Polyline straight(Vec2 from, Vec2 to) {
  Polyline line;
  for (int k = 0; k <= 40; ++k) line.push_back(lerp(from, to, k / 40.0));
  return line;
}

/// In both directions: the sheet in which it ends under or over the other one.
std::vector<int> sheets_along(ShapeMesh const& shape, Polyline line) {
  std::vector<int> sheets;
  TriangleGrid const triangles(shape.mesh.rest);
  for (int way = 0; way < 2; ++way) {
    for (auto const& place : line_in_sheets(shape, triangles, line))
      sheets.push_back(place ? shape.sheets[place->triangle] : -1);
    std::reverse(line.begin(), line.end());
  }
  return sheets;
}

TEST(LineInSheets, ALineStaysInTheSheetInWhichItIsAlone) {
  auto const shape = body_mesh(std::vector{polygon_outline(folded_limb_corners())}, 1);
  ASSERT_TRUE(shape.has_value() && shape->sheets.back() == 1);
  EXPECT_EQ(sheets_along(*shape, straight({20, 60}, {180, 60})), std::vector<int>(82, 1));
  EXPECT_EQ(sheets_along(*shape, straight({290, 60}, {130, 60})), std::vector<int>(82, 0));
}

TEST(LineInSheets, WhatIsNowhereAloneIsInTheSmallestAndWhatIsOutsideInNone) {
  auto const shape = body_mesh(std::vector{polygon_outline(folded_limb_corners())}, 1);
  ASSERT_TRUE(shape.has_value());
  EXPECT_EQ(sheets_along(*shape, straight({130, 60}, {190, 60})), std::vector<int>(82, 0));
  EXPECT_EQ(sheets_along(*shape, straight({400, 60}, {400, 90})), std::vector<int>(82, -1));
}

}  // namespace
}  // namespace inkflate
