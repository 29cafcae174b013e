// SPDX-License-Identifier: Apache-2.0
#include "editor/transform_drag.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr Rect kBox = {{100, 100}, {300, 200}};

ToolPointer pointer_at(Vec2 canvas, Modifiers modifiers = {}) {
  ToolPointer pointer;
  pointer.canvas = pointer.screen = canvas;
  pointer.modifiers = modifiers;
  return pointer;
}

ToolTransforming held(FrameHandle handle, Vec2 from, Rect const& box = kBox) {
  return {handle, pointer_at(from), box, {LayerId{1}}};
}

Affine map_of(FrameHandle handle, Vec2 from, Vec2 to, Modifiers modifiers = {}) {
  auto const map = drag_map(held(handle, from), pointer_at(to, modifiers));
  EXPECT_TRUE(map.has_value());
  return map.value_or(Affine{});
}

void expect_at(Affine const& map, Vec2 from, Vec2 to) {
  EXPECT_NEAR(distance(map(from), to), 0, 1e-9) << map(from).x << ' ' << map(from).y;
}

constexpr Modifiers kShift = {true, false, false};
constexpr Modifiers kAlt = {false, false, true};

TEST(DragMap, NoMotionIsTheIdentity) {
  for (int i = 0; i <= static_cast<int>(FrameHandle::Turn); ++i) {
    EXPECT_EQ(map_of(static_cast<FrameHandle>(i), {120.3, 99.7}, {120.3, 99.7}), Affine{});
  }
}

TEST(DragMap, EachHandleGoesAlongAndTheOppositeSideStays) {
  struct Case {
    FrameHandle handle;
    Vec2 held;
    Vec2 stays;
    Vec2 delta;  // what of the motion counts
  };
  Vec2 const delta = {20, -30};
  for (auto const& each : {Case{FrameHandle::Left, {100, 150}, {300, 150}, {20, 0}},
                           Case{FrameHandle::Right, {300, 150}, {100, 150}, {20, 0}},
                           Case{FrameHandle::Top, {200, 100}, {200, 200}, {0, -30}},
                           Case{FrameHandle::Bottom, {200, 200}, {200, 100}, {0, -30}},
                           Case{FrameHandle::TopLeft, {100, 100}, {300, 200}, delta},
                           Case{FrameHandle::TopRight, {300, 100}, {100, 200}, delta},
                           Case{FrameHandle::BottomLeft, {100, 200}, {300, 100}, delta},
                           Case{FrameHandle::BottomRight, {300, 200}, {100, 100}, delta}}) {
    // Held a little aside of its middle: it does not jump.
    Vec2 const from = each.held + Vec2{3, 2};
    auto const map = map_of(each.handle, from, from + delta);
    expect_at(map, each.held, each.held + each.delta);
    expect_at(map, each.stays, each.stays);
  }
}

TEST(DragMap, AltScalesAboutTheCentre) {
  auto const map = map_of(FrameHandle::Right, {300, 150}, {350, 150}, kAlt);
  expect_at(map, {300, 150}, {350, 150});
  expect_at(map, {100, 150}, {50, 150});
  expect_at(map, {200, 150}, {200, 150});
}

TEST(DragMap, ShiftKeepsProportions) {
  auto const corner = map_of(FrameHandle::BottomRight, {300, 200}, {500, 210}, kShift);
  EXPECT_NEAR(corner.a, 2, 1e-12);
  EXPECT_NEAR(corner.d, 2, 1e-12);
  auto const edge = map_of(FrameHandle::Top, {200, 100}, {200, 50}, kShift);
  EXPECT_NEAR(edge.a, 1.5, 1e-12);
  EXPECT_NEAR(edge.d, 1.5, 1e-12);
  expect_at(edge, {200, 200}, {200, 200});
  auto const side = map_of(FrameHandle::Left, {100, 150}, {500, 150}, kShift);
  EXPECT_NEAR(side.a, -1, 1e-12);
  EXPECT_NEAR(side.d, 1, 1e-12);  // mirrored only where it is held
}

TEST(DragMap, PulledThroughTheOtherSideItIsMirrored) {
  auto const map = map_of(FrameHandle::Right, {300, 150}, {0, 150});
  EXPECT_NEAR(map.a, -0.5, 1e-12);
}

TEST(DragMap, NothingIsMadeFlat) {
  for (double const x : {100.0, 100.0 + 1e-9, 100.0 - 1e-9}) {
    for (auto const modifiers : {Modifiers{}, kShift}) {
      auto const map = map_of(FrameHandle::BottomRight, {300, 200}, {x, 100}, modifiers);
      EXPECT_GE(std::abs(map.a) * kBox.width(), 1);
      EXPECT_GE(std::abs(map.d) * kBox.height(), 1);
    }
  }
}

TEST(DragMap, ASideWithoutLengthStaysSo) {
  Rect const line = {{100, 150}, {300, 150}};
  auto const map =
      drag_map(held(FrameHandle::BottomRight, {300, 150}, line), pointer_at({500, 400}));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->d, 1);
  EXPECT_NEAR(map->a, 2, 1e-12);
  Rect const tiny = {{100, 100}, {100.5, 100.5}};
  auto const grown = drag_map(held(FrameHandle::Right, {100.5, 100}, tiny), pointer_at({0, 0}));
  ASSERT_TRUE(grown);
  EXPECT_LE(grown->a, -1);
}

TEST(DragMap, TurnFollowsThePointerAboutTheCentre) {
  auto const map = map_of(FrameHandle::Turn, {200, 50}, {300, 150});
  expect_at(map, {200, 150}, {200, 150});
  expect_at(map, {200, 50}, {300, 150});
  EXPECT_NEAR(map.determinant(), 1, 1e-12);
}

TEST(DragMap, TurnWithShiftGoesInSteps) {
  auto const map = map_of(FrameHandle::Turn, {200, 50}, {229, 55}, kShift);
  auto const step = sin_cos(kPi / 12);
  EXPECT_NEAR(map.a, step.cos, 1e-12);
  EXPECT_NEAR(map.b, step.sin, 1e-12);
}

TEST(DragMap, MovesAlongOneAxisWithShift) {
  EXPECT_EQ(map_of(FrameHandle::Inside, {0, 0}, {9, -5}, kShift), Affine::translation({9, 0}));
  EXPECT_EQ(map_of(FrameHandle::Inside, {0, 0}, {4, -5}, kShift), Affine::translation({0, -5}));
}

TEST(DragMap, BeyondThePlaneOfADocumentThereIsNone) {
  EXPECT_FALSE(drag_map(held(FrameHandle::Inside, {0, 0}), pointer_at({1e6, 0})));
  Rect const tiny = {{100, 100}, {100.001, 200}};
  EXPECT_FALSE(
      drag_map(held(FrameHandle::TopRight, {100.001, 100}, tiny), pointer_at({1e6, 0}, kShift)));
}

}  // namespace
}  // namespace inkflate
