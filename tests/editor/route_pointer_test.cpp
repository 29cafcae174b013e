// SPDX-License-Identifier: Apache-2.0
#include "editor/route_pointer.h"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/trig.h"
#include "support/pointers.h"

namespace inkflate {
namespace {

using support::Person;
constexpr auto kMouse = PointerKind::Mouse;
constexpr auto kPen = PointerKind::Pen;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(RoutePointer, DragOfTheMouseWorksWithTheTool) {
  Person person;
  person.view.tool = Tool::HelpLine;
  person.press(kMouse, 1, {100, 100});
  person.move(kMouse, 1, {110, 120});
  person.release(kMouse, 1, {130, 140});
  EXPECT_EQ(person.told(), "PMR");
  for (auto const& each : person.to_tool) EXPECT_EQ(each.tool, Tool::HelpLine);
  EXPECT_EQ(person.last_pointer().screen, (Vec2{130, 140}));
  EXPECT_EQ(person.last_pointer().canvas,
            to_canvas(person.view.camera, person.view.size, {130, 140}));
  EXPECT_TRUE(person.state.down.empty());
}

TEST(RoutePointer, RightButtonIsTheFarSideForTheWholeDrag) {
  Person person;
  for (auto const button : {PointerButton::Secondary, PointerButton::Primary}) {
    bool const is_far = button == PointerButton::Secondary;
    person.press(kMouse, 1, {100, 100}, button);
    EXPECT_EQ(person.last_pointer().is_secondary, is_far);
    person.move(kMouse, 1, {110, 120});
    EXPECT_EQ(person.last_pointer().is_secondary, is_far);
    person.release(kMouse, 1, {110, 120}, button);
    EXPECT_EQ(person.last_pointer().is_secondary, is_far);
  }
}

TEST(RoutePointer, MouseWithoutButtonHovers) {
  Person person;
  person.move(kMouse, 1, {10, 10});
  EXPECT_EQ(person.told(), "H");
  person.view.mode = Mode::Inflate;
  person.move(kMouse, 1, {20, 10});
  EXPECT_EQ(person.told(), "H");
}

TEST(RoutePointer, PressureIsThePensOnly) {
  Person person;
  PointerEvent event;
  event.action = PointerAction::Press;
  event.button = PointerButton::Primary;
  event.pressure = 0.25;
  person.point(event);
  EXPECT_EQ(person.last_pointer().pressure, 1);
  event.kind = kPen;
  event.id = 2;
  person.point(event);
  EXPECT_EQ(person.last_pointer().pressure, 0.25);
  event.action = PointerAction::Move;
  event.pressure = 7;
  person.point(event);
  EXPECT_EQ(person.last_pointer().pressure, 1);
  event.pressure = kNan;
  person.point(event);
  EXPECT_EQ(person.last_pointer().pressure, 0.5);
}

TEST(RoutePointer, OtherEndOfThePenErases) {
  Person person;
  for (auto const tool : {Tool::Brush, Tool::Hand}) {
    person.view.tool = tool;
    person.press(kPen, 5, {1, 1}, PointerButton::Eraser);
    person.move(kPen, 5, {2, 2});
    person.release(kPen, 5, {2, 2}, PointerButton::Eraser);
  }
  EXPECT_EQ(person.told(), "PMRPMR");
  for (auto const& each : person.to_tool) EXPECT_EQ(each.tool, Tool::Eraser);
}

TEST(RoutePointer, SpaceMiddleButtonAndHandMoveThePaper) {
  enum class Way { Space, Middle, Hand };
  for (auto const way : {Way::Space, Way::Middle, Way::Hand}) {
    Person person;
    person.state.is_space_held = way == Way::Space;
    if (way == Way::Hand) person.view.tool = Tool::Hand;
    auto const button = way == Way::Middle ? PointerButton::Middle : PointerButton::Primary;
    auto const before = person.view.camera;
    person.press(kMouse, 1, {100, 100}, button);
    person.move(kMouse, 1, {110, 120});
    person.release(kMouse, 1, {115, 120}, button);
    EXPECT_EQ(person.told(), "");
    EXPECT_EQ(person.view.camera, panned(before, {15, 20}));
  }
}

TEST(RoutePointer, DragTurnsTheModelWithTheHand) {
  for (auto const mode : {Mode::Inflate, Mode::Animate}) {
    Person person;
    person.view.mode = mode;
    person.press(kMouse, 1, {100, 100});
    person.move(kMouse, 1, {110, 120});
    EXPECT_NEAR(person.view.model.turn_rad, -0.1, 1e-12);
    EXPECT_NEAR(person.view.model.tilt_rad, 0.2, 1e-12);
    person.move(kMouse, 1, {110, 9000});
    EXPECT_EQ(person.view.model.tilt_rad, kPi / 2);
    EXPECT_EQ(person.told(), "");
  }
}

TEST(RoutePointer, OtherDragsMoveTheModel) {
  enum class Way { Space, Middle, Secondary, Shift };
  for (auto const way : {Way::Space, Way::Middle, Way::Secondary, Way::Shift}) {
    Person person;
    person.view.mode = Mode::Inflate;
    person.state.is_space_held = way == Way::Space;
    PointerEvent event;
    event.action = PointerAction::Press;
    event.button = way == Way::Middle      ? PointerButton::Middle
                   : way == Way::Secondary ? PointerButton::Secondary
                                           : PointerButton::Primary;
    event.modifiers.is_shift = way == Way::Shift;
    person.point(event);
    event.action = PointerAction::Move;
    event.screen = {10, 20};
    person.point(event);
    EXPECT_EQ(person.view.model.pan_px, (Vec2{10, 20}));
    EXPECT_EQ(person.view.model.turn_rad, 0);
  }
}

TEST(RoutePointer, SecondPressSoonAndNearIsADoubleClick) {
  Person person;
  auto const click = [&](double time_s, Vec2 screen, PointerButton button) {
    person.time_s = time_s;
    person.press(kMouse, 1, screen, button);
    person.release(kMouse, 1, screen, button);
    return person.clicks();
  };
  auto const primary = PointerButton::Primary;
  EXPECT_EQ(click(1, {10, 10}, primary), 1);
  EXPECT_EQ(click(1.3, {14, 13}, primary), 2);
  EXPECT_EQ(click(1.5, {14, 13}, primary), 1);  // a third begins anew
  EXPECT_EQ(click(2.5, {14, 13}, primary), 1);  // too late
  EXPECT_EQ(click(2.6, {24, 13}, primary), 1);  // too far
  EXPECT_EQ(click(2.7, {24, 13}, PointerButton::Secondary), 1);
  EXPECT_EQ(click(2.8, {24, 13}, PointerButton::Secondary), 2);
}

TEST(RoutePointer, DragsPansAndCancelledPressesAreNoClicks) {
  Person person;
  person.press(kMouse, 1, {10, 10});
  person.move(kMouse, 1, {40, 10});
  person.release(kMouse, 1, {10, 10});
  person.press(kMouse, 1, {10, 10});
  EXPECT_EQ(person.clicks(), 1);
  person.cancel(kMouse, 1);
  person.press(kMouse, 1, {10, 10});
  EXPECT_EQ(person.clicks(), 1);
  person.release(kMouse, 1, {10, 10});
  person.press(kMouse, 1, {10, 10}, PointerButton::Middle);
  person.release(kMouse, 1, {10, 10}, PointerButton::Middle);
  person.press(kMouse, 1, {10, 10});
  EXPECT_EQ(person.clicks(), 1);
}

TEST(RoutePointer, CancelledPointerCancelsTheTool) {
  Person person;
  person.press(kMouse, 1, {10, 10});
  person.cancel(kMouse, 1);
  person.release(kMouse, 1, {10, 10});
  EXPECT_EQ(person.told(), "PC");
}

TEST(RoutePointer, LostReleaseKeepsWhatWasDone) {
  Person person;
  person.press(kMouse, 1, {10, 10});
  person.move(kMouse, 1, {20, 20});
  person.press(kMouse, 1, {50, 50});
  EXPECT_EQ(person.told(), "PMRP");
  auto const* release = std::get_if<ToolRelease>(&person.to_tool[2].event);
  ASSERT_NE(release, nullptr);
  EXPECT_EQ(release->pointer.screen, (Vec2{20, 20}));
}

TEST(RoutePointer, AnotherButtonTakesOverAndTheOldOnesReleaseMeansNothing) {
  Person person;
  person.press(kMouse, 1, {10, 10});
  person.press(kMouse, 1, {10, 10}, PointerButton::Secondary);
  EXPECT_EQ(person.told(), "PRP");
  person.release(kMouse, 1, {10, 10}, PointerButton::Primary);
  EXPECT_EQ(person.told(), "PRP");
  person.release(kMouse, 1, {10, 10}, PointerButton::Secondary);
  EXPECT_EQ(person.told(), "PRPR");
}

TEST(RoutePointer, PenTakesOverFromTheMouse) {
  Person person;
  person.press(kMouse, 1, {10, 10});
  person.press(kPen, 2, {50, 50});
  person.move(kMouse, 1, {20, 10});
  person.release(kMouse, 1, {20, 10});
  EXPECT_EQ(person.told(), "PRP");
  person.release(kPen, 2, {50, 50});
  EXPECT_EQ(person.told(), "PRPR");
}

TEST(RoutePointer, PlacesThatAreNoneAreDroppedButNoRelease) {
  Person person;
  person.press(kMouse, 1, {kNan, 10});
  EXPECT_EQ(person.told(), "");
  person.press(kMouse, 1, {10, 10});
  person.move(kMouse, 1, {10, kNan});
  person.release(kMouse, 1, {kNan, kNan});
  EXPECT_EQ(person.told(), "PR");
  EXPECT_EQ(person.last_pointer().screen, (Vec2{10, 10}));
}

TEST(RoutePointer, FarPlacesStayOnTheLargestCanvas) {
  Person person;
  person.view.camera.zoom = Camera::kLeastZoom;
  person.press(kMouse, 1, {1e300, -1e300});
  EXPECT_EQ(person.last_pointer().canvas, (Vec2{1e6, -1e6}));
}

TEST(RoutePointer, TimeNeverRunsBackwards) {
  Person person;
  person.time_s = 5;
  person.press(kMouse, 1, {10, 10});
  for (double const time_s : {4.0, kNan, -1e300}) {
    person.time_s = time_s;
    person.move(kMouse, 1, {10, 10});
    EXPECT_EQ(person.last_pointer().time_s, 5);
  }
}

TEST(RoutePointer, DroppedPointersDoNotCountUntilTheyAreLifted) {
  Person person;
  person.press(kMouse, 1, {10, 10});
  person.take(drop_pointers(person.state));
  EXPECT_EQ(person.told(), "PC");
  person.move(kMouse, 1, {20, 10});
  person.release(kMouse, 1, {20, 10});
  EXPECT_EQ(person.told(), "PC");
  person.press(kMouse, 1, {20, 10});
  EXPECT_EQ(person.told(), "PCP");
}

TEST(RoutePointer, WhatIsLostForeverIsForgotten) {
  Person person;
  for (int id = 0; id < 1000; ++id) person.press(PointerKind::Touch, id, {1.0 * id, 0});
  EXPECT_LE(person.state.down.size(), 32U);
}

}  // namespace
}  // namespace inkflate
