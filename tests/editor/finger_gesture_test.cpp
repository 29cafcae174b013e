// SPDX-License-Identifier: Apache-2.0
#include "editor/finger_gesture.h"

#include <gtest/gtest.h>

#include "support/pointers.h"

namespace inkflate {
namespace {

using support::Person;
constexpr auto kTouch = PointerKind::Touch;
constexpr auto kPen = PointerKind::Pen;
constexpr auto kMouse = PointerKind::Mouse;

using Actions = std::vector<std::string>;

/// Fingers come down one after the other, and are lifted.
void tap(Person& person, int fingers, double duration_s, double moved_px = 0) {
  for (int i = 0; i < fingers; ++i) person.press(kTouch, 10 + i, {100.0 + 50 * i, 100});
  person.time_s += duration_s;
  for (int i = 0; i < fingers; ++i) {
    person.release(kTouch, 10 + i, {100.0 + 50 * i + moved_px, 100});
  }
}

TEST(FingerGesture, OneFingerWorksWithTheTool) {
  Person person;
  person.press(kTouch, 7, {10, 10});
  person.move(kTouch, 7, {20, 10});
  person.release(kTouch, 7, {30, 10});
  EXPECT_EQ(person.told(), "PMR");
  EXPECT_EQ(person.last_pointer().pressure, 1);
}

TEST(FingerGesture, OneFingerMovesThePaperOnceAPenWasSeen) {
  Person person;
  person.press(kPen, 1, {10, 10});
  person.release(kPen, 1, {10, 10});
  person.time_s = 10;
  auto const before = person.view.camera;
  person.press(kTouch, 7, {10, 10});
  person.move(kTouch, 7, {20, 15});
  EXPECT_EQ(person.told(), "PR");
  EXPECT_EQ(person.view.camera, panned(before, {10, 5}));
}

TEST(FingerGesture, OneFingerTurnsTheModel) {
  Person person;
  person.view.mode = Mode::Inflate;
  person.press(kTouch, 7, {10, 10});
  person.move(kTouch, 7, {20, 10});
  EXPECT_NEAR(person.view.model.turn_rad, -0.1, 1e-12);
}

TEST(FingerGesture, SecondFingerMakesAPinchAndLeavesNoStroke) {
  Person person;
  person.press(kTouch, 1, {400, 500});
  person.move(kTouch, 1, {420, 500});
  person.press(kTouch, 2, {620, 500});
  EXPECT_EQ(person.told(), "PMC");
  // Apart about the middle, which is where the view's middle was: the paper is twice as large.
  auto const middle = to_canvas(person.view.camera, person.view.size, {520, 500});
  person.move(kTouch, 1, {320, 500});
  person.move(kTouch, 2, {720, 500});
  EXPECT_NEAR(person.view.camera.zoom, 2, 1e-9);
  auto const after = to_canvas(person.view.camera, person.view.size, {520, 500});
  EXPECT_NEAR(distance(after, middle), 0, 1e-9);
  EXPECT_EQ(person.told(), "PMC");
}

TEST(FingerGesture, PinchZoomsAndMovesTheModel) {
  Person person;
  person.view.mode = Mode::Animate;
  person.time_s = 1;
  person.press(kTouch, 1, {400, 500});
  person.press(kTouch, 2, {600, 500});
  person.time_s = 2;
  person.move(kTouch, 1, {300, 500});
  person.move(kTouch, 2, {700, 500});
  EXPECT_NEAR(person.view.model.zoom, 2, 1e-9);
  EXPECT_EQ(person.view.model.turn_rad, 0);
}

TEST(FingerGesture, ThirdFingerDoesNotMakeThePaperJump) {
  Person person;
  person.press(kTouch, 1, {400, 500});
  person.press(kTouch, 2, {600, 500});
  person.time_s = 1;
  person.move(kTouch, 1, {390, 500});
  auto const before = person.view.camera;
  person.press(kTouch, 3, {900, 900});
  person.move(kTouch, 3, {900, 900});
  EXPECT_NEAR(distance(person.view.camera.centre, before.centre), 0, 1e-9);
  EXPECT_NEAR(person.view.camera.zoom, before.zoom, 1e-9);
}

TEST(FingerGesture, FingersAtOnePlaceDoNotZoom) {
  Person person;
  person.press(kTouch, 1, {400, 500});
  person.press(kTouch, 2, {400, 500});
  person.time_s = 1;
  person.move(kTouch, 1, {500, 500});
  EXPECT_EQ(person.view.camera.zoom, 1);
}

TEST(FingerGesture, LastFingerOfAPinchWaitsForAnother) {
  Person person;
  person.press(kTouch, 1, {400, 500});
  person.press(kTouch, 2, {600, 500});
  person.time_s = 1;
  person.move(kTouch, 2, {650, 500});
  person.release(kTouch, 2, {650, 500});
  auto const before = person.view.camera;
  person.move(kTouch, 1, {300, 300});
  EXPECT_EQ(person.view.camera, before);
  EXPECT_EQ(person.told(), "PC");
  person.press(kTouch, 3, {500, 300});
  person.move(kTouch, 3, {700, 300});
  EXPECT_NEAR(person.view.camera.zoom, before.zoom * 2, 1e-9);
  person.release(kTouch, 3, {700, 300});
  person.release(kTouch, 1, {300, 300});
  EXPECT_EQ(person.state.use, PointerUse::None);
  EXPECT_EQ(person.told(), "PC");
  EXPECT_TRUE(person.actions.empty());
}

TEST(FingerGesture, TapOfTwoUndoesOfThreeRedoes) {
  Person person;
  auto const before = person.view.camera;
  tap(person, 2, 0.2, 5);
  EXPECT_EQ(person.actions, Actions({"undo"}));
  tap(person, 3, 0.2, 5);
  EXPECT_EQ(person.actions, Actions({"undo", "redo"}));
  EXPECT_EQ(person.view.camera, before);
}

TEST(FingerGesture, OtherTapsDoNothing) {
  Person person;
  tap(person, 1, 0.1);
  tap(person, 4, 0.1);
  tap(person, 2, 0.4);
  tap(person, 2, 0.1, 15);
  EXPECT_TRUE(person.actions.empty());
}

TEST(FingerGesture, CancelledFingersAreNoTap) {
  Person person;
  person.press(kTouch, 1, {400, 500});
  person.press(kTouch, 2, {600, 500});
  person.cancel(kTouch, 1);
  person.release(kTouch, 2, {600, 500});
  EXPECT_TRUE(person.actions.empty());
}

TEST(FingerGesture, FingersMayClickFartherApartThanAMouse) {
  Person person;
  person.press(kTouch, 1, {100, 100});
  person.release(kTouch, 1, {100, 100});
  person.press(kTouch, 2, {115, 115});
  EXPECT_EQ(person.clicks(), 2);
}

TEST(FingerGesture, PalmBesideAPenIsIgnored) {
  Person person;
  person.press(kPen, 1, {10, 10});
  person.time_s = 5;  // a pen may rest
  person.press(kTouch, 7, {90, 90});
  person.move(kTouch, 7, {95, 90});
  person.release(kPen, 1, {10, 10});
  person.time_s = 5.3;
  person.press(kTouch, 8, {90, 90});
  person.release(kTouch, 7, {95, 90});
  person.release(kTouch, 8, {90, 90});
  EXPECT_EQ(person.told(), "PR");
  EXPECT_EQ(person.view.camera, Camera());
  EXPECT_TRUE(person.actions.empty());
}

TEST(FingerGesture, PalmThatComesBeforeThePenLeavesNoStroke) {
  for (auto const action : {PointerAction::Press, PointerAction::Move}) {
    Person person;
    person.time_s = 3;
    person.press(kTouch, 7, {90, 90});
    person.time_s = 3.2;
    person.point(action, kPen, 1, {10, 10});
    EXPECT_EQ(person.told().substr(0, 2), "PC");
    person.move(kTouch, 7, {95, 90});
    person.release(kTouch, 7, {95, 90});
    EXPECT_EQ(person.told(), action == PointerAction::Press ? "PCP" : "PCH");
  }
}

TEST(FingerGesture, PenTakesOverFromAFingerWhoseStrokeStays) {
  Person person;
  person.press(kTouch, 7, {90, 90});
  person.time_s = 2;
  person.move(kTouch, 7, {95, 90});
  person.press(kPen, 1, {10, 10});
  EXPECT_EQ(person.told(), "PMRP");
}

TEST(FingerGesture, FingerBesideAWorkingMouseIsIgnored) {
  Person person;
  person.press(kMouse, 1, {10, 10});
  person.press(kTouch, 7, {90, 90});
  person.release(kMouse, 1, {10, 10});
  person.move(kTouch, 7, {95, 90});
  EXPECT_EQ(person.told(), "PR");
}

TEST(FingerGesture, MouseEndsAPinch) {
  Person person;
  person.press(kTouch, 1, {400, 500});
  person.press(kTouch, 2, {600, 500});
  person.press(kMouse, 9, {10, 10});
  EXPECT_EQ(person.told(), "PCP");
  auto const before = person.view.camera;
  person.time_s = 1;
  person.move(kTouch, 2, {700, 500});
  EXPECT_EQ(person.view.camera, before);
}

TEST(FingerGesture, HoverOfAFingerThatIsNotDownIsNothing) {
  Person person;
  person.move(kTouch, 3, {10, 10});
  EXPECT_EQ(person.told(), "");
}

}  // namespace
}  // namespace inkflate
