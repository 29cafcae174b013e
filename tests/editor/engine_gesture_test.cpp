// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "editor/engine.h"
#include "io/document_hash.h"
#include "support/artist.h"

namespace inkflate {
namespace {

constexpr Vec2 kMiddle = {500, 500};
constexpr auto kSecondary = PointerButton::Secondary;

TEST(EngineGesture, EscDropsTheStrokeInProgress) {
  Artist artist;
  auto const start = artist.hash();
  artist.press({100, 100});
  artist.move({300, 300});
  artist.key("Escape");
  artist.move({400, 100});
  artist.release({400, 100});
  EXPECT_EQ(artist.hash(), start);
  EXPECT_FALSE(artist.engine().history().can_undo());
  EXPECT_EQ(artist.state().view.tool, Tool::Brush);
}

TEST(EngineGesture, EscThenClearsTheSelectionThenTakesTheBrush) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("v");
  artist.click(kMiddle);
  EXPECT_EQ(artist.state().view.selection.size(), 1U);
  artist.key("Escape");
  EXPECT_TRUE(artist.state().view.selection.empty());
  EXPECT_EQ(artist.state().view.tool, Tool::Select);
  artist.key("Escape");
  EXPECT_EQ(artist.state().view.tool, Tool::Brush);
}

TEST(EngineGesture, ADragIsOneEntry) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("v");
  int const before = artist.engine().history().size();
  artist.draw({{500, 500}, {520, 500}, {560, 510}, {600, 520}});
  EXPECT_EQ(artist.engine().history().size(), before + 1);
  EXPECT_EQ(artist.state().undo_name, "select_tool");
}

TEST(EngineGesture, TheGestureUnderWayIsSeenButNotYetDone) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("v");
  auto const before = artist.hash();
  artist.press({500, 500});
  artist.move({600, 500});
  EXPECT_NE(artist.hash(), before);
  EXPECT_EQ(document_hash(to_project(artist.engine().history().document())), before);
  artist.key("z", {.is_ctrl = true});  // takes back the gesture and nothing else
  EXPECT_EQ(artist.hash(), before);
  EXPECT_FALSE(artist.engine().history().can_redo());
}

TEST(EngineGesture, ADoubleClickWithTheBrushDuplicatesThePartUnderIt) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.double_click({500, 400});
  auto const& layers = *artist.document().layers;
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0]->layer.id, static_cast<LayerId>(2));
  EXPECT_TRUE(artist.document().loose.is_empty());
  artist.double_click({500, 400});  // the same again takes the copy back
  EXPECT_EQ(artist.document().layers->size(), 1U);
  artist.double_click({500, 400}, kSecondary);
  EXPECT_EQ(artist.document().layers->at(1)->layer.id, static_cast<LayerId>(3));
}

TEST(EngineGesture, ADoubleClickWhileOtherStrokesAreLooseDrawsDots) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.draw({{480, 450}, {520, 450}});
  artist.double_click({500, 400});
  EXPECT_EQ(artist.document().layers->size(), 1U);
  EXPECT_EQ(artist.document().loose.size(), 3);
}

TEST(EngineGesture, ErasingInAPartOpensItAndEnterClosesItAgain) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("e");
  artist.draw({{500, 280}, {500, 320}});
  EXPECT_TRUE(artist.only_layer().is_open);
  EXPECT_GE(artist.document().layers->at(0)->strokes.size(), 3);
  artist.key("b");
  artist.draw({{470, 305}, {500, 300}, {530, 305}});
  artist.key("Enter");
  auto const& layer = artist.only_layer();
  EXPECT_FALSE(layer.is_open);
  EXPECT_EQ(layer.id, static_cast<LayerId>(1));
}

TEST(EngineGesture, ErasingAcrossSeveralStrokesIsOneEntry) {
  Artist artist;
  for (double const y : {300.0, 400.0, 500.0}) artist.draw({{100, y}, {900, y}});
  auto const before = artist.hash();
  artist.key("e");
  artist.draw({{500, 280}, {500, 320}, {500, 420}, {500, 520}});
  EXPECT_EQ(artist.document().loose.size(), 6);
  EXPECT_EQ(artist.state().undo_name, "eraser");
  artist.act("undo");
  EXPECT_EQ(artist.hash(), before);
}

TEST(EngineGesture, GesturesAreUndoneUnderTheNameOfTheirTool) {
  Artist artist;
  artist.key("l");
  artist.draw({{100, 100}, {200, 200}});
  EXPECT_EQ(artist.state().undo_name, "help_line");
  artist.key("h");
  artist.draw({{100, 100}, {200, 200}});
  EXPECT_EQ(artist.engine().history().size(), 1) << "panning is no entry";
}

TEST(EngineGesture, ThePartUnderThePointerIsHovered) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("v");
  artist.move(kMiddle);
  EXPECT_EQ(artist.state().view.hover, LayerId{1});
  artist.move({5, 5});
  EXPECT_EQ(artist.state().view.hover, LayerId::None);
  artist.move(kMiddle);
  artist.act("undo");
  EXPECT_EQ(artist.state().view.hover, LayerId::None) << "the part is gone";
}

TEST(EngineGesture, ATapOfTwoFingersUndoes) {
  Artist artist;
  artist.draw({{100, 100}, {200, 200}});
  for (auto const action : {PointerAction::Press, PointerAction::Release}) {
    for (int finger = 1; finger <= 2; ++finger) {
      PointerEvent event;
      event.action = action;
      event.kind = PointerKind::Touch;
      event.id = finger;
      event.screen = {300.0 + 100 * finger, 400};
      event.time_s = 50 + 0.01 * finger;
      artist.send(event);
    }
  }
  EXPECT_TRUE(is_blank(artist.document()));
  EXPECT_EQ(artist.state().redo_name, "brush");
}

TEST(EngineGesture, AFileInTheMiddleOfAStrokeDropsTheStroke) {
  Artist artist;
  artist.press({100, 100});
  artist.move({300, 300});
  artist.send(FileEvent{{}, "none.svg", FileUse::Open});
  EXPECT_TRUE(artist.has_said(Word::CannotRead));
  artist.release({400, 100});
  EXPECT_TRUE(is_blank(artist.document()));
}

TEST(EngineGesture, ADoubleClickAfterSomethingElseTakesNothingBack) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.act("select_all");
  artist.click(kMiddle);
  artist.act("thickness", "5");
  int const before = artist.engine().history().position();
  artist.click_again(kMiddle);
  EXPECT_EQ(artist.only_layer().thickness, 5);
  EXPECT_EQ(artist.engine().history().position(), before + 1);
}

TEST(EngineGesture, ADoubleClickOnAPartThatIsDrawnAgainDrawsDots) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.click(kMiddle);
  artist.act("select_all");
  artist.act("open_part");
  artist.double_click(kMiddle);
  EXPECT_EQ(artist.document().layers->size(), 1U);
  EXPECT_EQ(artist.document().loose.size(), 1);
}

TEST(EngineGesture, AnotherModeEndsWhatTheHandWasDoing) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("2");
  artist.press(kMiddle);
  artist.move({600, 500});
  artist.key("1");
  double const turn_rad = artist.state().view.model.turn_rad;
  artist.move({700, 500});
  artist.release({700, 500});
  EXPECT_EQ(artist.state().view.model.turn_rad, turn_rad);
  EXPECT_TRUE(artist.document().loose.is_empty());
}

TEST(EngineGesture, SpaceHeldPansAndDrawsNothing) {
  Artist artist;
  KeyEvent space;
  space.key = " ";
  artist.send(space);
  artist.draw({{100, 100}, {200, 150}});
  EXPECT_TRUE(is_blank(artist.document()));
  EXPECT_EQ(artist.state().view.camera.centre, (Vec2{400, 450}));
}

TEST(EngineGesture, WheelWithCtrlZoomsAboutThePointer) {
  Artist artist;
  WheelEvent wheel;
  wheel.screen = {250, 250};
  wheel.delta_px = {0, -100};
  wheel.modifiers.is_ctrl = true;
  artist.send(wheel);
  auto const view = artist.state().view;
  EXPECT_GT(view.camera.zoom, 1);
  auto const place = to_canvas(view.camera, view.size, {250, 250});
  EXPECT_NEAR(place.x, 250, 1e-9);
  EXPECT_NEAR(place.y, 250, 1e-9);
}

TEST(EngineGesture, PinchesOfTheSystemZoomToo) {
  Artist artist;
  artist.send(GestureEvent{{500, 500}, 2, {}});
  EXPECT_NEAR(artist.state().view.camera.zoom, 2, 1e-12);
}

TEST(EngineGesture, HostileNumbersChangeNothing) {
  Artist artist;
  double const nan = std::numeric_limits<double>::quiet_NaN();
  double const far = std::numeric_limits<double>::infinity();
  for (auto const at : {Vec2{nan, 5}, Vec2{far, -far}, Vec2{1e300, 1e300}}) {
    artist.draw({at, {10, 10}, at});
    WheelEvent wheel;
    wheel.screen = at;
    wheel.delta_px = at;
    artist.send(wheel);
    artist.send(GestureEvent{at, nan, at});
    artist.send(GestureEvent{{5, 5}, -1, {}});
  }
  auto const view = artist.state().view;
  EXPECT_TRUE(is_finite(view.camera.centre) && std::isfinite(view.camera.zoom));
  auto const project = to_project(artist.document());
  for (auto const& stroke : project.drawing.sketch.strokes) {
    for (auto const& sample : stroke.samples) EXPECT_TRUE(is_finite(sample.position));
  }
}

}  // namespace
}  // namespace inkflate
