// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/artist.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

/// Two discs that overlap, the second one in front and selected.
class PartHandlers : public testing::Test {
 protected:
  PartHandlers() {
    artist.draw_circle({400, 500}, 150);
    artist.key("Enter");
    artist.draw_circle({500, 500}, 150);
    artist.key("Enter");
    artist.act("select", "2");
    artist.messages.clear();
  }

  Layer const& layer(int id) {
    return find_layer(artist.document(), static_cast<LayerId>(id))->layer;
  }

  std::vector<int> order() {
    std::vector<int> ids;
    for (auto const id : layer_order(artist.document())) ids.push_back(static_cast<int>(id));
    return ids;
  }

  double left() { return bounds(flatten(layer(2).outlines.at(0), 0.1)).min.x; }

  Word said() { return artist.messages.empty() ? Word::Recovered : artist.messages.back().word; }

  Artist artist;
};

TEST_F(PartHandlers, RenameThicknessAndFillChangeTheSelection) {
  artist.act("rename_part", "arm");
  artist.act("thickness", "4.5");
  artist.act("fill", "#336699");
  EXPECT_EQ(layer(2).name, "arm");
  EXPECT_EQ(layer(2).thickness, 4.5);
  EXPECT_EQ(layer(2).fill, (Colour{0x33, 0x66, 0x99}));
  EXPECT_NE(layer(1).name, "arm");
  artist.act("fill", "none");
  EXPECT_FALSE(layer(2).fill);
}

TEST_F(PartHandlers, ASliderThatIsDraggedIsOneEntry) {
  int const before = artist.engine().history().position();
  for (auto const* const value : {"2.5", "3", "3.5", "4"}) artist.act("thickness", value);
  EXPECT_EQ(artist.engine().history().position(), before + 1);
  artist.act("undo");
  EXPECT_EQ(layer(2).thickness, 2);
  // What was undone stays to be redone until something new is done.
  artist.act("redo");
  EXPECT_EQ(layer(2).thickness, 4);
}

TEST_F(PartHandlers, ASliderOfAnotherPartIsAnotherEntry) {
  artist.act("thickness", "3");
  artist.act("select", "1");
  artist.act("thickness", "4");
  EXPECT_EQ(layer(2).thickness, 3);
  EXPECT_EQ(layer(1).thickness, 4);
  artist.act("undo");
  EXPECT_EQ(layer(1).thickness, 2);
  EXPECT_EQ(layer(2).thickness, 3);
}

TEST_F(PartHandlers, ASliderAfterSomethingElseIsAnotherEntry) {
  artist.act("thickness", "3");
  artist.act("hide_part", "1");
  artist.act("undo");
  artist.act("thickness", "4");
  artist.act("undo");
  EXPECT_EQ(layer(2).thickness, 3);
}

TEST_F(PartHandlers, ASliderThatComesBackToWhereItWasIsNoEntry) {
  int const before = artist.engine().history().position();
  artist.act("thickness", "3");
  artist.act("thickness", "2");
  EXPECT_EQ(layer(2).thickness, 2);
  EXPECT_EQ(artist.engine().history().position(), before);
  EXPECT_TRUE(artist.messages.empty());
}

TEST_F(PartHandlers, ARefusedValueLeavesTheSliderWhereItWas) {
  artist.act("thickness", "3");
  artist.act("thickness", "1000");
  EXPECT_EQ(layer(2).thickness, 3);
  EXPECT_EQ(said(), Word::CannotDo);
}

TEST_F(PartHandlers, PartsThatAreSoAlreadyDoNotStandInTheWay) {
  artist.act("thickness", "3");
  artist.act("select_all");
  artist.act("thickness", "3");
  EXPECT_EQ(layer(1).thickness, 3);
  artist.act("lock_part", "2");
  artist.act("lock_part");
  EXPECT_TRUE(layer(1).is_locked);
  EXPECT_TRUE(layer(2).is_locked);
}

TEST_F(PartHandlers, APartThatThereIsNotIsNeitherHiddenNorTheSelectionInItsPlace) {
  for (auto const* const action : {"hide_part", "lock_part"}) {
    for (auto const* const argument : {"77", "-1", "1e300", "head"}) {
      artist.act(action, argument);
      EXPECT_EQ(said(), Word::CannotDo);
      EXPECT_FALSE(layer(2).is_hidden);
      EXPECT_FALSE(layer(2).is_locked);
    }
  }
}

TEST_F(PartHandlers, HiddenPartsCannotBeSelected) {
  artist.act("hide_part", "1");
  artist.act("select", "1 2");
  EXPECT_EQ(artist.state().view.selection, std::vector<LayerId>{LayerId{2}});
}

TEST_F(PartHandlers, ArgumentsThatAreNoneAreRefused) {
  for (auto const* const action : {"thickness", "fill", "move_part"}) {
    artist.messages.clear();
    artist.act(action, "purple elephant");
    EXPECT_EQ(said(), Word::CannotDo) << action;
  }
  artist.act("thickness", "1e9");
  EXPECT_EQ(said(), Word::CannotDo);
  EXPECT_EQ(layer(2).thickness, 2);
}

TEST_F(PartHandlers, WithoutASelectionThatIsSaid) {
  artist.act("select", "");
  for (auto const* const action :
       {"rename_part", "hide_part", "lock_part", "depth_nearer", "flip_vertical", "nudge_up",
        "open_part", "redraw_part", "close_part", "delete", "zoom_selection", "duplicate_behind"}) {
    artist.messages.clear();
    artist.act(action, action == std::string("rename_part") ? "x" : "");
    EXPECT_EQ(said(), Word::NothingSelected) << action;
  }
  artist.messages.clear();
  artist.act("thickness", "3");
  EXPECT_EQ(said(), Word::NothingSelected);
  artist.messages.clear();
  artist.act("fill", "none");
  EXPECT_EQ(said(), Word::NothingSelected);
  artist.messages.clear();
  artist.act("move_part", "0");
  EXPECT_EQ(said(), Word::NothingSelected);
}

TEST_F(PartHandlers, HiddenPartsAreNoLongerSelectedAndComeBackById) {
  artist.act("hide_part");
  EXPECT_TRUE(layer(2).is_hidden);
  EXPECT_TRUE(artist.state().view.selection.empty());
  artist.act("hide_part", "2");
  EXPECT_FALSE(layer(2).is_hidden);
}

TEST_F(PartHandlers, LockTurnsRound) {
  artist.act("lock_part");
  EXPECT_TRUE(layer(2).is_locked);
  artist.key("Delete");
  EXPECT_EQ(order(), (std::vector<int>{1, 2}));
  artist.act("lock_part");
  EXPECT_FALSE(layer(2).is_locked);
  artist.act("lock_part", "1");
  EXPECT_TRUE(layer(1).is_locked);
}

TEST_F(PartHandlers, DepthKeysMovePastPartsThatOverlap) {
  artist.key("PageDown");
  EXPECT_EQ(order(), (std::vector<int>{2, 1}));
  artist.key("PageUp");
  EXPECT_EQ(order(), (std::vector<int>{1, 2}));
  artist.key("End");
  EXPECT_EQ(order(), (std::vector<int>{2, 1}));
  artist.key("Home");
  EXPECT_EQ(order(), (std::vector<int>{1, 2}));
  artist.act("move_part", "0");
  EXPECT_EQ(order(), (std::vector<int>{2, 1}));
}

TEST_F(PartHandlers, ArrowsMoveByOnePxAndWithShiftByTen) {
  double const before = left();
  artist.key("ArrowRight");
  EXPECT_NEAR(left(), before + 1, 1e-9);
  artist.key("ArrowRight", {.is_shift = true});
  EXPECT_NEAR(left(), before + 11, 1e-9);
  artist.key("ArrowLeft", {.is_shift = true});
  artist.key("ArrowLeft");
  for (auto const* const key : {"ArrowUp", "ArrowDown"}) {
    artist.key(key);
    artist.key(key, {.is_shift = true});
  }
  EXPECT_NEAR(left(), before, 1e-9);
}

TEST_F(PartHandlers, FlippedTwiceIsAsBefore) {
  double const before = left();
  artist.key("H", {.is_shift = true});
  artist.key("V", {.is_shift = true});
  artist.key("V", {.is_shift = true});
  artist.key("H", {.is_shift = true});
  EXPECT_NEAR(left(), before, 1e-9);
}

TEST_F(PartHandlers, DuplicatesAreSelected) {
  artist.key("d", {.is_ctrl = true});
  EXPECT_EQ(order(), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(artist.state().view.selection, std::vector<LayerId>{static_cast<LayerId>(3)});
  artist.act("duplicate_behind");
  EXPECT_EQ(order().front(), 4);
  artist.act("duplicate_before", "1");
  EXPECT_EQ(order().back(), 5);
}

// It lies exactly on its original, so that nothing is seen of it.
TEST_F(PartHandlers, ACopyBehindOrBeforeAllIsSaid) {
  auto const last = [&] { return artist.messages.back().word; };
  artist.act("duplicate_behind", "1");
  EXPECT_EQ(last(), Word::CopiedBehind);
  artist.act("duplicate_behind", "1");
  EXPECT_EQ(last(), Word::CopyRemoved);
  artist.act("duplicate_before", "1");
  EXPECT_EQ(last(), Word::CopiedBefore);
}

TEST_F(PartHandlers, DeleteTakesTheSelection) {
  artist.key("a", {.is_ctrl = true});
  artist.key("Backspace");
  EXPECT_TRUE(order().empty());
  EXPECT_TRUE(artist.state().view.selection.empty());
}

TEST_F(PartHandlers, SelectTakesIdsAndNothingElse) {
  artist.act("select", "2, 1 2 77");
  EXPECT_EQ(artist.state().view.selection.size(), 2U);
  artist.act("select", "1 two");
  EXPECT_EQ(said(), Word::CannotDo);
  EXPECT_EQ(artist.state().view.selection.size(), 2U);
}

TEST_F(PartHandlers, AnOpenPartIsDrawnOnAndClosesAsTheSamePart) {
  artist.act("open_part");
  EXPECT_TRUE(layer(2).is_open);
  artist.draw({{620, 460}, {700, 470}, {705, 530}, {625, 540}});
  artist.key("Enter");
  EXPECT_FALSE(layer(2).is_open);
  EXPECT_EQ(layer(2).strokes.size() + layer(2).details.size() + layer(2).noise.size(), 3U);
  EXPECT_EQ(order(), (std::vector<int>{1, 2}));
}

TEST_F(PartHandlers, ARedrawnPartKeepsItsPlaceAndLook) {
  artist.act("select", "1");
  artist.act("fill", "#ff0000");
  artist.act("redraw_part");
  artist.draw_circle({300, 300}, 100);
  artist.key("Enter");
  EXPECT_EQ(order(), (std::vector<int>{1, 2}));
  EXPECT_EQ(layer(1).fill, (Colour{255, 0, 0}));
  EXPECT_NEAR(bounds(flatten(layer(1).outlines.at(0), 0.1)).min.x, 200, 5);
}

TEST_F(PartHandlers, AnOpenPartThatIsClosedKeepsItsOutline) {
  auto const before = layer(2).outlines;
  artist.act("open_part");
  artist.act("close_part");
  EXPECT_FALSE(layer(2).is_open);
  EXPECT_EQ(layer(2).outlines, before);
}

}  // namespace
}  // namespace inkflate
