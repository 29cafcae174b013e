// SPDX-License-Identifier: Apache-2.0
#include "editor/view.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr ViewSize kSize = {800, 600};

std::vector<Camera> some_cameras() {
  return {{}, {{-200, 70}, 3.7, false}, {{12345.6, -9876.5}, 0.02, true}, {{3, 4}, 64, true}};
}

void expect_near(Vec2 a, Vec2 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(Camera, CentreLiesInTheMiddleOfTheView) {
  for (auto const& camera : some_cameras()) {
    expect_near(canvas_to_screen(camera, kSize)(camera.centre), {400, 300}, 1e-9);
  }
}

TEST(Camera, ScreenAndCanvasAreInverse) {
  for (auto const& camera : some_cameras()) {
    Vec2 const screen = {17, 593};
    auto const canvas = to_canvas(camera, kSize, screen);
    expect_near(canvas_to_screen(camera, kSize)(canvas), screen, 1e-9);
  }
}

TEST(Camera, MirroredPaperGoesRightWhereItWentLeft) {
  Camera const camera;
  auto const straight = canvas_to_screen(camera, kSize)(camera.centre + Vec2{10, 20});
  auto const turned = canvas_to_screen(mirrored(camera), kSize)(camera.centre + Vec2{10, 20});
  EXPECT_EQ(straight, (Vec2{410, 320}));
  EXPECT_EQ(turned, (Vec2{390, 320}));
  EXPECT_EQ(mirrored(mirrored(camera)), camera);
}

TEST(Camera, PannedPaperFollowsTheHand) {
  for (auto const& camera : some_cameras()) {
    Vec2 const from = {100, 200};
    auto const held = to_canvas(camera, kSize, from);
    auto const moved = panned(camera, {31, -17});
    expect_near(canvas_to_screen(moved, kSize)(held), from + Vec2{31, -17}, 1e-9);
  }
}

TEST(Camera, ZoomKeepsThePlaceUnderThePointer) {
  for (auto const& camera : some_cameras()) {
    for (double const factor : {1e-9, 0.3, 1.0, 1.1, 5.0, 1e9}) {
      Vec2 const pointer = {731, 12};
      auto const next = zoomed(camera, kSize, pointer, factor);
      expect_near(to_canvas(next, kSize, pointer), to_canvas(camera, kSize, pointer), 1e-9);
    }
  }
}

TEST(Camera, ZoomStaysWithinItsLimits) {
  EXPECT_EQ(zoomed(Camera(), kSize, Vec2(), 1e300).zoom, Camera::kLargestZoom);
  EXPECT_EQ(zoomed(Camera(), kSize, Vec2(), 1e-300).zoom, Camera::kLeastZoom);
}

TEST(Camera, PaperStaysWithinReach) {
  auto const far = panned(Camera(), {1e308, -1e308});
  EXPECT_EQ(far.centre, (Vec2{-1e6, 1e6}));
  auto const farther = zoomed(far, kSize, {1e308, 1e308}, 0.5);
  EXPECT_EQ(farther.centre, (Vec2{-1e6, -1e6}));
}

TEST(Camera, WhatMeansNothingChangesNothing) {
  Camera const camera = {{1, 2}, 3, true};
  for (double const bad : {kNan, kInfinite, -kInfinite}) {
    EXPECT_EQ(panned(camera, {bad, 0}), camera);
    EXPECT_EQ(zoomed(camera, kSize, {0, bad}, 2), camera);
    EXPECT_EQ(zoomed(camera, kSize, {}, bad), camera);
    EXPECT_EQ(fitted(camera, kSize, {{0, 0}, {bad, 1}}), camera);
    EXPECT_EQ(fitted(camera, kSize, {{bad, 0}, {1, 1}}), camera);
  }
  EXPECT_EQ(zoomed(camera, kSize, {}, 0), camera);
  EXPECT_EQ(zoomed(camera, kSize, {}, -1), camera);
  EXPECT_EQ(fitted(camera, kSize, Rect()), camera);
  EXPECT_EQ(fitted(camera, kSize, {{3, 0}, {1, 1}}), camera);
}

TEST(Camera, FittedBoxFillsTheViewButForAMargin) {
  Rect const box = {{100, 100}, {500, 200}};
  for (auto const& camera : some_cameras()) {
    auto const next = fitted(camera, kSize, box);
    auto const map = canvas_to_screen(next, kSize);
    EXPECT_EQ(next.is_mirrored, camera.is_mirrored);
    expect_near(map(box.centre()), {400, 300}, 1e-9);
    double const width_px = distance(map(box.min), map({box.max.x, box.min.y}));
    EXPECT_LT(width_px, kSize.width_px);
    EXPECT_GT(width_px, 0.8 * kSize.width_px);
  }
}

TEST(Camera, FittedBoxStaysFreeOfWhatLiesOverTheEdges) {
  ViewSize const size = {1000, 500, {70, 60, 270, 130}};
  auto const room = free_room(size);
  EXPECT_EQ(room, (Rect{{70, 60}, {730, 370}}));
  for (Rect const& box :
       {Rect{{0, 0}, {10, 100}}, Rect{{-50, 20}, {50, 30}}, Rect{{0, 0}, {7, 5}}}) {
    for (bool const is_mirrored : {false, true}) {
      auto const map = canvas_to_screen(fitted({{}, 1, is_mirrored}, size, box), size);
      Rect screen;
      screen.include(map(box.min));
      screen.include(map(box.max));
      EXPECT_GT(screen.min.x, room.min.x);
      EXPECT_GT(screen.min.y, room.min.y);
      EXPECT_LT(screen.max.x, room.max.x);
      EXPECT_LT(screen.max.y, room.max.y);
    }
  }
}

TEST(Camera, FittedBoxLiesInTheMiddleOfTheViewWhereThatIsFree) {
  ViewSize const size = {1000, 500, {70, 60, 270, 130}};
  Rect const tall = {{0, 0}, {10, 100}};
  auto const map = canvas_to_screen(fitted({}, size, tall), size);
  EXPECT_NEAR(map(tall.centre()).x, 500, 1e-9);
  EXPECT_NEAR(map(tall.centre()).y, 215, 1e-9) << "it fills the height that is free";
}

TEST(Camera, AWindowThatIsAllBarsStillShowsSomething) {
  EXPECT_EQ(free_room({1000, 100, {0, 45, 0, 45}}), (Rect{{0, 25}, {1000, 75}}));
  EXPECT_EQ(free_height_px({1000, 100, {0, 45, 0, 45}}), 50);
}

TEST(Camera, FittedPlaceComesToTheMiddleAtTheSameZoom) {
  Camera const camera = {{1, 2}, 3, false};
  EXPECT_EQ(fitted(camera, kSize, {{7, 8}, {7, 8}}), (Camera{{7, 8}, 3, false}));
  // A line has a fitting zoom.
  EXPECT_NEAR(fitted(camera, kSize, {{0, 8}, {880, 8}}).zoom, 0.8, 1e-9);
}

TEST(ModelView, TiltStaysWithinAQuarterTurnAndTurnWithinOne) {
  auto const over = turned({}, 3 * kPi, 10);
  EXPECT_NEAR(over.turn_rad, -kPi, 1e-9);
  EXPECT_EQ(over.tilt_rad, kPi / 2);
  EXPECT_EQ(turned(over, 0, -100).tilt_rad, -kPi / 2);
  auto const hostile = turned({}, 1e300, 1e300);
  EXPECT_LE(std::abs(hostile.turn_rad), 1e6);
  EXPECT_EQ(turned({}, kNan, 1).tilt_rad, 0);
  EXPECT_EQ(turned({}, 1, kInfinite).turn_rad, 0);
}

TEST(ModelView, ZoomKeepsThePlaceUnderThePointer) {
  ModelView model;
  model.pan_px = {30, -40};
  model.zoom = 2;
  Vec2 const pointer = {700, 100};
  // What lies there: its way from the model's middle, at zoom 1.
  auto const held = (pointer - Vec2{400, 300} - model.pan_px) / model.zoom;
  auto const next = zoomed(model, kSize, pointer, 1.7);
  expect_near(Vec2{400, 300} + next.pan_px + held * next.zoom, pointer, 1e-9);
  EXPECT_NEAR(next.zoom, 3.4, 1e-12);
}

TEST(ModelView, StaysWithinItsLimits) {
  EXPECT_EQ(zoomed(ModelView(), kSize, {400, 300}, 1e9).zoom, kLargestModelZoom);
  EXPECT_EQ(zoomed(ModelView(), kSize, {400, 300}, 1e-9).zoom, kLeastModelZoom);
  EXPECT_LE(norm(panned(ModelView(), {1e308, 1e308}).pan_px), 1e6);
  EXPECT_EQ(panned(ModelView(), {kNan, 1}).pan_px, Vec2());
  EXPECT_EQ(zoomed(ModelView(), kSize, {kNan, 1}, 2).zoom, 1);
  EXPECT_EQ(zoomed(ModelView(), kSize, {}, -2).zoom, 1);
}

TEST(View, KnowsWhatIsSelected) {
  View view;
  EXPECT_FALSE(is_selected(view, LayerId{3}));
  view.selection = {LayerId{1}, LayerId{3}, LayerId{8}};
  EXPECT_TRUE(is_selected(view, LayerId{3}));
  EXPECT_FALSE(is_selected(view, LayerId{4}));
}

}  // namespace
}  // namespace inkflate
