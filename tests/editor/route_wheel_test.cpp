// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "support/pointers.h"

namespace inkflate {
namespace {

using support::Person;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void turn_wheel(Person& person, Vec2 delta_px, Modifiers modifiers = {}) {
  person.take(route_wheel(person.state, {{300, 200}, delta_px, modifiers}, person.view));
}

TEST(RouteWheel, MovesThePaper) {
  Person person;
  turn_wheel(person, {30, 100});
  EXPECT_EQ(person.view.camera, panned(Camera(), {-30, -100}));
}

TEST(RouteWheel, MovesItSidewaysWithShift) {
  Modifiers const shift = {true, false, false};
  for (Vec2 const delta_px : {Vec2{0, 100}, Vec2{100, 0}}) {
    Person person;
    turn_wheel(person, delta_px, shift);
    EXPECT_EQ(person.view.camera, panned(Camera(), {-100, 0}));
  }
}

TEST(RouteWheel, ZoomsAboutThePointerWithCtrl) {
  Person person;
  Modifiers const ctrl = {false, true, false};
  auto const held = to_canvas(person.view.camera, person.view.size, {300, 200});
  turn_wheel(person, {0, -100}, ctrl);
  EXPECT_GT(person.view.camera.zoom, 1.1);
  auto const after = to_canvas(person.view.camera, person.view.size, {300, 200});
  EXPECT_NEAR(distance(after, held), 0, 1e-9);
  turn_wheel(person, {0, 100}, ctrl);
  EXPECT_NEAR(person.view.camera.zoom, 1, 1e-12);
  turn_wheel(person, {0, 1e300}, ctrl);
  EXPECT_GT(person.view.camera.zoom, 0.8);
}

TEST(RouteWheel, ZoomsTheModel) {
  Person person;
  person.view.mode = Mode::Inflate;
  turn_wheel(person, {0, -100});
  EXPECT_GT(person.view.model.zoom, 1.1);
  EXPECT_EQ(person.view.camera, Camera());
}

TEST(RouteWheel, WhatMeansNothingChangesNothing) {
  Person person;
  turn_wheel(person, {kNan, 0});
  turn_wheel(person, {0, 0});
  person.take(route_gesture(person.state, {{kNan, 0}, 2, {kNan, 0}}, person.view));
  person.take(route_gesture(person.state, {{0, 0}, -1, {0, kNan}}, person.view));
  EXPECT_EQ(person.view.camera, Camera());
}

TEST(RouteWheel, ChangesTheReachWhileTheDeformToolIsDown) {
  Person person;
  person.view.tool = Tool::Deform;
  Vec2 const up = {0, -100};
  auto const reaches = [&](Modifiers modifiers) {
    auto const step = route_wheel(person.state, {{300, 200}, up, modifiers}, person.view);
    return std::get_if<ToBendReach>(&step.routed.at(0)) != nullptr;
  };
  EXPECT_FALSE(reaches({}));
  person.press(PointerKind::Mouse, 1, {300, 200});
  EXPECT_TRUE(reaches({}));
  EXPECT_FALSE(reaches({false, true, false})) << "Ctrl zooms as ever";
  auto const step = route_wheel(person.state, {{300, 200}, up, {}}, person.view);
  EXPECT_GT(std::get<ToBendReach>(step.routed.at(0)).factor, 1);
}

TEST(RouteGesture, PinchOfATrackpadZoomsAboutThePointerAndMoves) {
  Person person;
  auto const held = to_canvas(person.view.camera, person.view.size, {300, 200});
  person.take(route_gesture(person.state, {{310, 220}, 1.5, {10, 20}}, person.view));
  EXPECT_NEAR(person.view.camera.zoom, 1.5, 1e-12);
  auto const after = to_canvas(person.view.camera, person.view.size, {310, 220});
  EXPECT_NEAR(distance(after, held), 0, 1e-9);
}

}  // namespace
}  // namespace inkflate
