// SPDX-License-Identifier: Apache-2.0
#include "editor/engine.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "editor/action_handlers.h"
#include "support/artist.h"

namespace inkflate {
namespace {

constexpr Vec2 kMiddle = {500, 500};
constexpr auto kSecondary = PointerButton::Secondary;

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
  EXPECT_TRUE(artist.has_said(Word::CannotDo));
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
  auto const& layer = artist.only_layer();
  EXPECT_EQ(layer.outlines.size(), 1U);
  EXPECT_EQ(layer.strokes.size(), 2U);
  EXPECT_FALSE(artist.state().has_rough_strokes);
  ASSERT_TRUE(artist.has_said(Word::ClosedGaps));
  EXPECT_EQ(artist.messages.back().arguments, std::vector<std::string>{"2"});
}

TEST(Engine, UndoGivesTheRoughStrokesBackAsTheyWere) {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  auto const before = artist.hash();
  artist.key("Enter");
  artist.key("z", {.is_ctrl = true});
  EXPECT_EQ(artist.hash(), before);
  EXPECT_EQ(artist.state().redo_name, "simplify");
  artist.key("y", {.is_ctrl = true});
  artist.only_layer();
}

TEST(Engine, UndoAllIsTheEmptyPaperAndRedoAllIsTheEnd) {
  Artist artist;
  auto const start = artist.hash();
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  artist.act("select_all");
  artist.act("thickness", "3");
  artist.key("ArrowLeft");
  auto const end = artist.hash();
  int steps = 0;
  while (is_enabled(artist, "undo")) {
    artist.act("undo");
    ++steps;
  }
  EXPECT_EQ(steps, 5);
  EXPECT_EQ(artist.hash(), start);
  while (is_enabled(artist, "redo")) artist.act("redo");
  EXPECT_EQ(artist.hash(), end);
  artist.act("redo");
  EXPECT_TRUE(artist.has_said(Word::NothingToRedo));
}

TEST(Engine, NothingToUndoIsSaid) {
  Artist artist;
  artist.act("undo");
  EXPECT_TRUE(artist.has_said(Word::NothingToUndo));
  artist.key("Enter");
  EXPECT_TRUE(artist.has_said(Word::NothingRough));
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

TEST(Engine, ANewOneHasNothingToSave) { EXPECT_TRUE(Artist().state().is_saved); }

TEST(Engine, WhatIsUndoneToTheBeginningHasNothingToSave) {
  Artist artist;
  artist.draw({{100, 100}, {200, 100}});
  EXPECT_FALSE(artist.state().is_saved);
  artist.act("undo");
  EXPECT_TRUE(artist.state().is_saved);
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
  auto const before = artist.hash();
  artist.draw({{200, 700}, {800, 700}});
  artist.act("eraser");
  artist.draw({{300, 500}, {300, 700}});
  artist.act("undo");
  artist.act("undo");
  EXPECT_EQ(artist.hash(), before);
  artist.act("hide_part", "1");
  EXPECT_EQ(artist.document().layers->at(0)->strokes.size(), 2);
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

TEST(Engine, EdgesThatAreNoneOrTooManyAreIgnored) {
  Artist artist;
  ViewEdges const edges = {10, 20, 30, 40};
  artist.send(ResizeEvent{640, 480, edges});
  EXPECT_EQ(artist.state().view.size.edges, edges);
  for (ViewEdges const& bad :
       {ViewEdges{-1, 0, 0, 0}, ViewEdges{400, 0, 400, 0}, ViewEdges{0, 300, 0, 300},
        ViewEdges{0, 0, static_cast<double>(NAN), 0}}) {
    artist.send(ResizeEvent{640, 480, bad});
    EXPECT_EQ(artist.state().view.size.edges, ViewEdges{});
  }
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

}  // namespace
}  // namespace inkflate
