// SPDX-License-Identifier: Apache-2.0
#include "editor/engine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "editor/action_handlers.h"
#include "io/document_hash.h"
#include "support/artist.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

constexpr Vec2 kMiddle = {500, 500};
constexpr auto kSecondary = PointerButton::Secondary;

std::uint64_t hash_of(Artist const& artist) { return document_hash(to_project(artist.document())); }

Layer const& only_layer(Artist const& artist) {
  auto const& layers = *artist.document().layers;
  EXPECT_EQ(layers.size(), 1U);
  return layers.at(0)->layer;
}

bool has_said(Artist const& artist, Word word) {
  for (auto const& message : artist.messages) {
    if (message.word == word) return true;
  }
  return false;
}

bool is_enabled(Artist const& artist, std::string const& action) {
  auto const enabled = artist.state().enabled;
  return std::find(enabled.begin(), enabled.end(), action) != enabled.end();
}

TEST(Engine, EveryActionIsDoneHereOrLeftToTheStudio) {
  std::vector<std::string> left;
  for (auto const& action : actions()) {
    if (find_handler(action.name) == nullptr) left.emplace_back(action.name);
  }
  EXPECT_EQ(left, (std::vector<std::string>{"open", "export", "open_template", "help", "palette"}));
}

TEST(Engine, AnUnknownActionIsSaid) {
  Artist artist;
  artist.act("make_coffee");
  EXPECT_TRUE(has_said(artist, Word::CannotDo));
  EXPECT_TRUE(artist.studio_actions.empty());
}

TEST(Engine, StudioActionsAreHandedBack) {
  Artist artist;
  artist.key("?");
  EXPECT_EQ(artist.studio_actions, std::vector<std::string>{"help"});
}

TEST(Engine, RoughStrokesBecomeOnePartByEnter) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  EXPECT_TRUE(artist.state().has_rough_strokes);
  artist.key("Enter");
  auto const& layer = only_layer(artist);
  EXPECT_EQ(layer.outlines.size(), 1U);
  EXPECT_EQ(layer.strokes.size(), 2U);
  EXPECT_FALSE(artist.state().has_rough_strokes);
  ASSERT_TRUE(has_said(artist, Word::ClosedGaps));
  EXPECT_EQ(artist.messages.back().arguments, std::vector<std::string>{"2"});
}

TEST(Engine, UndoGivesTheRoughStrokesBackAsTheyWere) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  auto const before = hash_of(artist);
  artist.key("Enter");
  artist.key("z", {.is_ctrl = true});
  EXPECT_EQ(hash_of(artist), before);
  EXPECT_EQ(artist.state().redo_name, "simplify");
  artist.key("y", {.is_ctrl = true});
  only_layer(artist);
}

TEST(Engine, UndoAllIsTheEmptyPaperAndRedoAllIsTheEnd) {
  Artist artist;
  auto const start = hash_of(artist);
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.act("select_all");
  artist.act("thickness", "3");
  artist.key("ArrowLeft");
  auto const end = hash_of(artist);
  int steps = 0;
  while (is_enabled(artist, "undo")) {
    artist.act("undo");
    ++steps;
  }
  EXPECT_EQ(steps, 5);
  EXPECT_EQ(hash_of(artist), start);
  while (is_enabled(artist, "redo")) artist.act("redo");
  EXPECT_EQ(hash_of(artist), end);
  artist.act("redo");
  EXPECT_TRUE(has_said(artist, Word::NothingToRedo));
}

TEST(Engine, NothingToUndoIsSaid) {
  Artist artist;
  artist.act("undo");
  EXPECT_TRUE(has_said(artist, Word::NothingToUndo));
  artist.key("Enter");
  EXPECT_TRUE(has_said(artist, Word::NothingRough));
}

TEST(Engine, EscDropsTheStrokeInProgress) {
  Artist artist;
  auto const start = hash_of(artist);
  artist.press({100, 100});
  artist.move({300, 300});
  artist.key("Escape");
  artist.move({400, 100});
  artist.release({400, 100});
  EXPECT_EQ(hash_of(artist), start);
  EXPECT_FALSE(artist.engine().history().can_undo());
  EXPECT_EQ(artist.state().view.tool, Tool::Brush);
}

TEST(Engine, EscThenClearsTheSelectionThenTakesTheBrush) {
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

TEST(Engine, StrokesOfTheRightButtonBecomeAPartBehindAllOthers) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.draw_circle({600, 500}, 150, 6, kSecondary);
  artist.key("Enter");
  auto const& layers = *artist.document().layers;
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(layers[0]->layer.id, static_cast<LayerId>(2));
}

TEST(Engine, ADragIsOneEntry) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("v");
  int const before = artist.engine().history().size();
  artist.draw({{500, 500}, {520, 500}, {560, 510}, {600, 520}});
  EXPECT_EQ(artist.engine().history().size(), before + 1);
  EXPECT_EQ(artist.state().undo_name, "select_tool");
}

TEST(Engine, TheGestureUnderWayIsSeenButNotYetDone) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("v");
  auto const before = hash_of(artist);
  artist.press({500, 500});
  artist.move({600, 500});
  EXPECT_NE(hash_of(artist), before);
  EXPECT_EQ(document_hash(to_project(artist.engine().history().document())), before);
  artist.key("z", {.is_ctrl = true});  // takes back the gesture and nothing else
  EXPECT_EQ(hash_of(artist), before);
  EXPECT_FALSE(artist.engine().history().can_redo());
}

TEST(Engine, ADoubleClickWithTheBrushDuplicatesThePartUnderIt) {
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

TEST(Engine, ADoubleClickWhileOtherStrokesAreLooseDrawsDots) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.draw({{480, 450}, {520, 450}});
  artist.double_click({500, 400});
  EXPECT_EQ(artist.document().layers->size(), 1U);
  EXPECT_EQ(artist.document().loose.size(), 3);
}

TEST(Engine, ErasingInAPartOpensItAndEnterClosesItAgain) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("e");
  artist.draw({{500, 280}, {500, 320}});
  EXPECT_TRUE(only_layer(artist).is_open);
  EXPECT_GE(artist.document().layers->at(0)->strokes.size(), 3);
  artist.key("b");
  artist.draw({{470, 305}, {500, 300}, {530, 305}});
  artist.key("Enter");
  auto const& layer = only_layer(artist);
  EXPECT_FALSE(layer.is_open);
  EXPECT_EQ(layer.id, static_cast<LayerId>(1));
}

TEST(Engine, ErasingAcrossSeveralStrokesIsOneEntry) {
  Artist artist;
  for (double const y : {300.0, 400.0, 500.0}) artist.draw({{100, y}, {900, y}});
  auto const before = hash_of(artist);
  artist.key("e");
  artist.draw({{500, 280}, {500, 320}, {500, 420}, {500, 520}});
  EXPECT_EQ(artist.document().loose.size(), 6);
  EXPECT_EQ(artist.state().undo_name, "eraser");
  artist.act("undo");
  EXPECT_EQ(hash_of(artist), before);
}

TEST(Engine, GesturesAreUndoneUnderTheNameOfTheirTool) {
  Artist artist;
  artist.key("l");
  artist.draw({{100, 100}, {200, 200}});
  EXPECT_EQ(artist.state().undo_name, "help_line");
  artist.key("h");
  artist.draw({{100, 100}, {200, 200}});
  EXPECT_EQ(artist.engine().history().size(), 1) << "panning is no entry";
}

TEST(Engine, ThePartUnderThePointerIsHovered) {
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

TEST(Engine, ATapOfTwoFingersUndoes) {
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

TEST(Engine, AFileInTheMiddleOfAStrokeDropsTheStroke) {
  Artist artist;
  artist.press({100, 100});
  artist.move({300, 300});
  artist.send(FileEvent{{}, "none.svg", FileUse::Open});
  EXPECT_TRUE(has_said(artist, Word::CannotRead));
  artist.release({400, 100});
  EXPECT_TRUE(is_blank(artist.document()));
}

TEST(Engine, ADoubleClickAfterSomethingElseTakesNothingBack) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.act("select_all");
  artist.click(kMiddle);
  artist.act("thickness", "5");
  int const before = artist.engine().history().position();
  artist.click_again(kMiddle);
  EXPECT_EQ(only_layer(artist).thickness, 5);
  EXPECT_EQ(artist.engine().history().position(), before + 1);
}

TEST(Engine, ADoubleClickOnAPartThatIsDrawnAgainDrawsDots) {
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

TEST(Engine, ANewOneHasNothingToSave) { EXPECT_TRUE(Artist().state().is_saved); }

TEST(Engine, WhatIsUndoneToTheBeginningHasNothingToSave) {
  Artist artist;
  artist.draw({{100, 100}, {200, 100}});
  EXPECT_FALSE(artist.state().is_saved);
  artist.act("undo");
  EXPECT_TRUE(artist.state().is_saved);
}

TEST(Engine, AnotherModeEndsWhatTheHandWasDoing) {
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

TEST(Engine, CopiesThatCannotBeMadeAreNotSelected) {
  Artist artist;
  artist.draw_circle(kMiddle, 100);
  artist.key("Enter");
  for (int i = 0; i < 10; ++i) {
    artist.act("select_all");
    artist.act("duplicate");
  }
  ASSERT_EQ(artist.document().layers->size(), 1024U);
  artist.act("select_all");
  artist.act("select_tool");
  artist.draw({kMiddle, {700, 500}}, PointerButton::Primary, {.is_alt = true});
  EXPECT_EQ(artist.document().layers->size(), 1024U);
  for (auto const id : artist.state().view.selection) {
    EXPECT_NE(find_layer(artist.document(), id), nullptr);
  }
}

TEST(Engine, APartThatIsLockedWhileItIsOpenDoesNotStandInTheWay) {
  Artist artist;
  artist.draw_circle({300, 300}, 100);
  artist.key("Enter");
  artist.act("select_all");
  artist.act("open_part");
  artist.act("lock_part", "1");
  artist.draw_circle({700, 700}, 100);
  artist.act("gap", "60");
  EXPECT_EQ(artist.state().choice.gap_px, 60);
  artist.key("Enter");
  ASSERT_EQ(artist.document().layers->size(), 2U);
  EXPECT_FALSE(artist.document().layers->at(1)->layer.is_open);
  EXPECT_FALSE(artist.state().has_rough_strokes);
  artist.act("lock_part", "1");
  EXPECT_TRUE(artist.state().has_rough_strokes);
}

TEST(Engine, APartThatIsHiddenWhileItIsOpenIsNotRubbedOut) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.act("select_all");
  artist.act("open_part");
  artist.act("hide_part", "1");
  auto const before = hash_of(artist);
  artist.draw({{200, 700}, {800, 700}});
  artist.act("eraser");
  artist.draw({{300, 500}, {300, 700}});
  artist.act("undo");
  artist.act("undo");
  EXPECT_EQ(hash_of(artist), before);
  artist.act("hide_part", "1");
  EXPECT_EQ(artist.document().layers->at(0)->strokes.size(), 2);
}

TEST(Engine, SpaceHeldPansAndDrawsNothing) {
  Artist artist;
  KeyEvent space;
  space.key = " ";
  artist.send(space);
  artist.draw({{100, 100}, {200, 150}});
  EXPECT_TRUE(is_blank(artist.document()));
  EXPECT_EQ(artist.state().view.camera.centre, (Vec2{400, 450}));
}

TEST(Engine, WheelWithCtrlZoomsAboutThePointer) {
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

TEST(Engine, PinchesOfTheSystemZoomToo) {
  Artist artist;
  artist.send(GestureEvent{{500, 500}, 2, {}});
  EXPECT_NEAR(artist.state().view.camera.zoom, 2, 1e-12);
}

TEST(Engine, SizesThatAreNoneAreIgnored) {
  Artist artist;
  artist.send(ResizeEvent{640, 480});
  for (double const bad :
       {0.0, -5.0, 1e9, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    artist.send(ResizeEvent{bad, 480});
    artist.send(ResizeEvent{640, bad});
  }
  EXPECT_EQ(artist.state().view.size, (ViewSize{640, 480}));
}

TEST(Engine, WhatIsRoughHasAPreviewAfterEveryStroke) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  auto const with_preview = artist.engine().scene().chunks.size();
  artist.key("z", {.is_ctrl = true});
  artist.key("z", {.is_ctrl = true});
  EXPECT_LT(artist.engine().scene().chunks.size(), with_preview);
  EXPECT_FALSE(artist.engine().has_work());
}

TEST(Engine, PartsAreListedFromTheFront) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.draw_circle({600, 500}, 100);
  artist.key("Enter");
  artist.act("select", "2");
  artist.act("rename_part", "arm");
  auto const rows = artist.state().layers;
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].name, "arm");
  EXPECT_TRUE(rows[0].is_selected);
  EXPECT_FALSE(rows[1].is_selected);
}

TEST(Engine, HostileNumbersChangeNothing) {
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
