// SPDX-License-Identifier: Apache-2.0
#include "editor/bend_gesture.h"

#include <gtest/gtest.h>

#include "editor/engine.h"
#include "io/document_hash.h"
#include "support/artist.h"

namespace inkflate {
namespace {

constexpr Vec2 kMiddle = {500, 500};
constexpr Vec2 kRight = {700, 500};  // on the line
constexpr Vec2 kLeft = {300, 500};
constexpr int kMostWork = 500;  // of one event, far more than any takes

/// A disc with the Deform tool in hand.
Artist bender() {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.key("d");
  return artist;
}

int entries(Artist& artist) { return artist.engine().history().size(); }

Rect box_of(Artist const& artist) {
  Rect box;
  for (auto const& piece : artist.only_layer().outlines.at(0).pieces) {
    for (auto const p : piece.curve.control) box.include(p);
  }
  return box;
}

/// How far the outline is from another, at most, by the points that they are made of.
double largest_move_px(Layer const& a, Layer const& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.outlines[0].pieces.size(); ++i) {
    auto const& from = a.outlines[0].pieces[i].curve.control;
    auto const& to = b.outlines[0].pieces.at(i).curve.control;
    for (std::size_t k = 0; k < from.size(); ++k) {
      largest = std::max(largest, distance(from[k], to[k]));
    }
  }
  return largest;
}

PointerEvent pointer(PointerAction action, Vec2 at, double time_s) {
  PointerEvent event;
  event.action = action;
  event.screen = at;
  event.time_s = time_s;
  if (action != PointerAction::Move) event.button = PointerButton::Primary;
  return event;
}

TEST(BendGesture, ADragIsOneEntryThatUndoTakesBackAndRedoGivesAgain) {
  auto artist = bender();
  auto const before = artist.hash();
  int const count = entries(artist);
  auto const right = box_of(artist).max.x;
  artist.draw({kRight, {720, 500}, {740, 500}, {760, 500}});
  EXPECT_EQ(entries(artist), count + 1);
  EXPECT_EQ(artist.state().undo_name, "deform");
  EXPECT_NEAR(box_of(artist).max.x, right + 60, 5);
  auto const after = artist.hash();
  artist.key("z", {.is_ctrl = true});
  EXPECT_EQ(artist.hash(), before);
  artist.key("y", {.is_ctrl = true});
  EXPECT_EQ(artist.hash(), after);
}

TEST(BendGesture, TheFarSideStaysWhereNothingHoldsThePart) {
  auto artist = bender();
  auto const left = box_of(artist).min.x;
  artist.draw({kRight, {740, 500}, {780, 500}});
  EXPECT_EQ(box_of(artist).min.x, left);
}

TEST(BendGesture, WithTheReachOfTheWholePartAPartThatNothingHoldsMovesAsAWhole) {
  auto artist = bender();
  artist.act("bend_reach", "whole");
  auto const before = box_of(artist);
  artist.draw({kRight, {720, 500}, {740, 500}});
  // To the decimals on which bent shapes lie.
  EXPECT_NEAR(box_of(artist).min.x, before.min.x + 40, 1e-3);
  EXPECT_NEAR(box_of(artist).width(), before.width(), 2e-3);
}

TEST(BendGesture, EscLeavesTheDocumentAsItWas) {
  auto artist = bender();
  auto const before = artist.hash();
  int const count = entries(artist);
  artist.press(kRight);
  artist.move({760, 500});
  EXPECT_NE(artist.hash(), before);
  artist.key("Escape");
  artist.move({800, 500});
  artist.release({800, 500});
  EXPECT_EQ(artist.hash(), before);
  EXPECT_EQ(entries(artist), count);
  EXPECT_EQ(artist.state().view.tool, Tool::Deform);
}

TEST(BendGesture, AnotherToolOrModeInTheMidstDropsTheDrag) {
  for (auto const* action : {"brush", "mode_inflate", "undo", "new"}) {
    auto artist = bender();
    int const count = entries(artist);
    artist.press(kRight);
    artist.move({760, 500});
    artist.act(action);
    artist.release({760, 500});
    EXPECT_LE(entries(artist), count + (std::string_view(action) == "new" ? 1 : 0)) << action;
  }
}

TEST(BendGesture, DeleteInTheMidstOfADragTakesBackJustThat) {
  auto artist = bender();
  auto const before = artist.hash();
  artist.press(kRight);
  artist.move({760, 500});
  artist.act("delete");
  artist.release({760, 500});
  EXPECT_EQ(artist.hash(), before);
}

TEST(BendGesture, WhatIsDraggedBackIsAsItWasUntilTheToolIsLeft) {
  auto artist = bender();
  auto const before = artist.only_layer();
  artist.draw({kRight, {730, 500}, {760, 500}});
  EXPECT_GT(largest_move_px(before, artist.only_layer()), 40);
  artist.draw({{760, 500}, {730, 500}, kRight});
  EXPECT_LT(largest_move_px(before, artist.only_layer()), 0.5);
}

TEST(BendGesture, ADragSettlesWithoutEventsAndThenThereIsNoWork) {
  auto artist = bender();
  auto& engine = artist.engine();
  engine.handle(pointer(PointerAction::Press, kRight, 1e3));
  // A batch of moves is followed once, when no event waits.
  for (int i = 1; i <= 20; ++i) {
    engine.handle(pointer(PointerAction::Move, kRight + Vec2{4.0 * i, 0}, 1e3));
  }
  ASSERT_TRUE(engine.has_work());
  int shares = 0;
  while (engine.has_work() && shares < kMostWork) {
    EXPECT_TRUE(engine.work().is_scene_changed);
    ++shares;
  }
  EXPECT_LT(shares, kMostWork);
  EXPECT_FALSE(engine.has_work());
  engine.handle(pointer(PointerAction::Release, {780, 500}, 1e3 + 1));
  EXPECT_EQ(engine.state().undo_name, "deform");
}

TEST(BendGesture, PinsArePutMovedTurnedAndDeletedByKeysAlone) {
  auto artist = bender();
  artist.key("a", {.is_ctrl = true});
  artist.key("D", {.is_shift = true});
  artist.key("D", {.is_shift = true});
  ASSERT_EQ(artist.only_layer().bend_pins.size(), 2U);
  EXPECT_GT(distance(artist.only_layer().bend_pins[0].position,
                     artist.only_layer().bend_pins[1].position),
            300);
  artist.key("n");
  ASSERT_TRUE(artist.state().view.pin);
  auto const place = artist.only_layer().bend_pins[0].position;
  artist.key("ArrowUp", {.is_shift = true});
  EXPECT_NEAR(distance(artist.only_layer().bend_pins[0].position, place + Vec2{0, -10}), 0, 1e-9);
  EXPECT_EQ(artist.state().undo_name, "deform");
  artist.key(".");
  EXPECT_TRUE(artist.only_layer().bend_pins[0].turn_rad);
  artist.act("free_pin");
  EXPECT_FALSE(artist.only_layer().bend_pins[0].turn_rad);
  artist.key("Delete");
  EXPECT_EQ(artist.only_layer().bend_pins.size(), 1U);
  artist.key("Delete");
  EXPECT_TRUE(artist.only_layer().bend_pins.empty());
  EXPECT_FALSE(artist.state().view.pin);
  // The part is not what was meant.
  artist.key("Delete");
  EXPECT_EQ(artist.document().layers->size(), 1U);
}

TEST(BendGesture, AClickPutsAPinAndADragMovesIt) {
  auto artist = bender();
  artist.click(kRight);
  artist.click(kLeft);
  ASSERT_EQ(artist.only_layer().bend_pins.size(), 2U);
  EXPECT_EQ(artist.state().view.pin, (BendPinRef{artist.only_layer().id, 1}));
  auto const held = artist.only_layer().bend_pins[1].position;
  auto const from = artist.only_layer().bend_pins[0].position;
  artist.draw({from, from + Vec2{20, 20}, from + Vec2{40, 60}});
  EXPECT_NEAR(distance(artist.only_layer().bend_pins[0].position, from + Vec2{40, 60}), 0, 1e-9);
  EXPECT_EQ(artist.only_layer().bend_pins[1].position, held);
  artist.click(from + Vec2{40, 60}, PointerButton::Primary, {.is_alt = true});
  EXPECT_EQ(artist.only_layer().bend_pins.size(), 1U);
  artist.act("delete_pins");
  EXPECT_TRUE(artist.only_layer().bend_pins.empty());
}

TEST(BendGesture, TheWheelAndTheBracketsChangeTheReachOfADrag) {
  auto artist = bender();
  artist.press(kRight);
  artist.move({760, 500});
  auto const narrow = artist.hash();
  EXPECT_FALSE(artist.state().view.settings.bend_reach);
  artist.send(WheelEvent{{760, 500}, {0, -120}, {}});
  auto const reach = artist.state().view.settings.bend_reach;
  ASSERT_TRUE(reach);
  EXPECT_GT(*reach, 0.3);
  EXPECT_NE(artist.hash(), narrow);
  artist.key("]");
  EXPECT_GT(*artist.state().view.settings.bend_reach, *reach);
  artist.release({760, 500});
  EXPECT_EQ(artist.state().undo_name, "deform");
  for (int i = 0; i < 40; ++i) artist.key("[");
  EXPECT_EQ(artist.state().view.settings.bend_reach, ToolSettings::kLeastBendReach);
  EXPECT_EQ(artist.state().view.settings.brush_px, ToolSettings{}.brush_px);
}

TEST(BendGesture, WithOnePartNobodyHasToSayWhichOneIsPinned) {
  auto artist = bender();
  EXPECT_TRUE(artist.state().view.selection.empty());
  artist.act("add_pin");
  EXPECT_EQ(artist.only_layer().bend_pins.size(), 1U);
  EXPECT_TRUE(artist.state().view.pin);
  artist.act("undo");
  artist.key("b");
  artist.draw_circle({200, 200}, 80);
  artist.key("Enter");
  artist.key("d");
  artist.act("select", "");
  int const before = entries(artist);
  artist.act("add_pin");
  EXPECT_EQ(entries(artist), before);
}

TEST(BendGesture, OfSeveralSelectedPartsNoneIsPinnedAndThatIsSaid) {
  auto artist = bender();
  artist.key("b");
  artist.draw_circle({200, 200}, 80);
  artist.key("Enter");
  artist.act("select_all");
  int const before = entries(artist);
  for (auto const* action : {"add_pin", "delete_pins"}) {
    auto const changes = artist.act(action);
    ASSERT_EQ(changes.messages.size(), 1U) << action;
    EXPECT_EQ(changes.messages[0].word, Word::SeveralSelected) << action;
  }
  EXPECT_EQ(entries(artist), before);
}

TEST(BendGesture, TheUsualReachIsThatOfThePartThatIsMeant) {
  auto artist = bender();
  EXPECT_EQ(artist.state().usual_reach, usual_bend_reach(BendMode::Body));
  artist.act("add_pin");
  EXPECT_EQ(artist.state().usual_reach, 1) << "a pin holds it";
  artist.key("b");
  artist.draw_circle({200, 200}, 80);
  artist.key("Enter");
  artist.act("select_all");
  artist.key("d");
  EXPECT_EQ(artist.state().usual_reach, usual_bend_reach(BendMode::Body)) << "none is meant";
}

TEST(BendGesture, TheWheelGoesOnFromTheUsualReach) {
  auto artist = bender();
  artist.act("add_pin");
  artist.key("[");
  auto const reach = artist.state().view.settings.bend_reach;
  ASSERT_TRUE(reach);
  EXPECT_NEAR(*reach, 1 / 1.25, 1e-9);
}

TEST(BendGesture, SettingsTakeWhatTheyMayBeAndNothingElse) {
  auto artist = bender();
  artist.act("bend_reach", "whole");
  EXPECT_EQ(artist.state().view.settings.bend_reach, 1);
  artist.act("bend_reach", "auto");
  EXPECT_FALSE(artist.state().view.settings.bend_reach);
  artist.act("bend_mode", "wire");
  artist.act("bend_body", "0.1");
  auto const settings = artist.state().view.settings;
  EXPECT_EQ(settings.bend_mode, BendMode::Wire);
  EXPECT_EQ(settings.bend_body, 0.1);
  for (auto const* wrong : {"0", "2", "nan", "", "far"}) {
    artist.act("bend_reach", wrong);
    artist.act("bend_mode", wrong);
    artist.act("bend_body", wrong);
    artist.act("add_pin", *wrong == 0 ? "x" : wrong);
  }
  EXPECT_EQ(artist.state().view.settings, settings);
}

TEST(BendGesture, TheSelectedPinAndTheRestAreTheToolsOwn) {
  auto artist = bender();
  artist.click(kRight);
  EXPECT_TRUE(artist.state().view.pin);
  artist.key("v");
  EXPECT_FALSE(artist.state().view.pin);
  // Going to a pin takes up the tool.
  artist.key("n");
  EXPECT_EQ(artist.state().view.tool, Tool::Deform);
  EXPECT_TRUE(artist.state().view.pin);
  artist.key("z", {.is_ctrl = true});
  EXPECT_FALSE(artist.state().view.pin);
}

TEST(BendGesture, RoughLinesBendToo) {
  Artist artist;
  artist.draw({{200, 500}, {400, 500}, {600, 500}, {800, 500}});
  artist.key("d");
  artist.draw({{600, 500}, {600, 540}, {600, 560}});
  EXPECT_EQ(artist.state().undo_name, "deform");
  EXPECT_EQ(artist.document().loose.size(), 1);
  EXPECT_GT(artist.document().loose[0]->box.max.y, 550);
}

TEST(BendGesture, WhatAJournalGivesBackIsTheSameDocument) {
  auto artist = bender();
  artist.click(kLeft);
  artist.draw({kRight, {740, 480}, {760, 460}});
  artist.key("ArrowLeft");
  artist.key(",");
  artist.press(kMiddle + Vec2{0, -200});
  artist.move({500, 250});  // and then it crashes
  artist.key("Escape");
  Engine again;
  again.recover(std::as_bytes(std::span(artist.journal.data(), artist.journal.size())));
  EXPECT_EQ(document_hash(to_project(again.document())),
            document_hash(to_project(artist.document())));
  EXPECT_EQ(again.history().size(), entries(artist));
}

}  // namespace
}  // namespace inkflate
