// SPDX-License-Identifier: Apache-2.0
#include "simplify/work_space.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simplify/simplify.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Rect box_of(Vec2 a, Vec2 b) {
  Rect box;
  box.include(a);
  box.include(b);
  return box;
}

TEST(WorkSpace, TheLongerSideIsAThousand) {
  auto const space = WorkSpace::around(box_of({-30, 50}, {20, 75}));
  EXPECT_LT(distance(space.work_point({-30, 50}), Vec2{12, 12}), 1e-9);
  EXPECT_LT(distance(space.work_point({20, 75}), Vec2{1012, 512}), 1e-9);
  EXPECT_DOUBLE_EQ(space.to_work * space.to_canvas, 1);
}

TEST(WorkSpace, CanvasPointIsTheWayBack) {
  auto const space = WorkSpace::around(box_of({1e5, -3}, {1e5 + 7, 2}));
  for (Vec2 const p : {Vec2{1e5 + 1, 1}, {1e5 + 6.9, -2}, {0, 0}})
    EXPECT_LT(distance(space.canvas_point(space.work_point(p)), p), 1e-9);
}

TEST(WorkSpace, AllPointsOfTheBoxAreOnTheLattice) {
  auto const space = WorkSpace::around(box_of({0.1, 0.1}, {0.7, 0.3}));
  for (Vec2 const p : {Vec2{0.1, 0.1}, {0.7, 0.3}, {0.4, 0.2}}) {
    auto const lattice = WorkSpace::lattice_point(space.work_point(p));
    EXPECT_GE(std::min(lattice.x, lattice.y), 0);
    EXPECT_LE(std::max(lattice.x, lattice.y), kLatticeSize);
    EXPECT_LT(distance(WorkSpace::lattice_position(lattice), space.work_point(p)), 0.05);
  }
}

TEST(WorkSpace, APointIsItsOwnCorner) {
  auto const space = WorkSpace::around(box_of({77, -5}, {77, -5}));
  EXPECT_EQ(space.work_point({77, -5}), (Vec2{12, 12}));
  EXPECT_EQ(space.canvas_point({12, 12}), (Vec2{77, -5}));
}

TEST(WorkSpace, WhatIsTooSmallForItsCoordinatesIsAPoint) {
  for (double const size : {5e-324, 1e-306, 1e-12, 1e-9, 1e-6}) {
    for (Vec2 const corner : {Vec2{0, 0}, {1e6, -1e6}}) {
      Vec2 const far = {corner.x - size, corner.y + size};
      auto const space = WorkSpace::around(box_of(corner, far));
      auto const p = space.work_point(far);
      EXPECT_TRUE(p.x >= 0 && p.x <= 1024 && p.y >= 0 && p.y <= 1024) << size;
      auto const drawing = simplify(
          sketch_of({line_stroke({corner, {far.x, corner.y}, far, {corner.x, far.y}, corner})}));
      if (drawing) {
        EXPECT_EQ(what_is_wrong(*drawing), "") << size;
      }
    }
  }
}

}  // namespace
}  // namespace inkflate
