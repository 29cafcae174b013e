// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/artist.h"

namespace inkflate {
namespace {

double area(Artist const& artist, std::size_t layer = 0) {
  double sum = 0;
  for (auto const& outline : artist.document().layers->at(layer)->layer.outlines) {
    sum += signed_area(flatten(outline, 0.1));
  }
  return sum;
}

/// A body with a bay: a U whose two arms come near each other at the top.
void draw_u(Artist& artist) {
  artist.draw({{300, 300}, {300, 700}, {700, 700}, {700, 300}, {600, 300}});
  artist.draw({{600, 300}, {600, 600}, {400, 600}, {400, 300}, {300, 300}});
}

TEST(DrawHandlers, StrokesThatEncloseNothingAreSaidWithTheirPlace) {
  Artist artist;
  artist.draw({{100, 100}, {150, 100}});
  artist.key("Enter");
  ASSERT_TRUE(artist.has_said(Word::NotClosed));
  EXPECT_TRUE(artist.messages.back().place);
  EXPECT_EQ(artist.document().loose.size(), 1);
}

TEST(DrawHandlers, StrokesOnAClosedPartAreSaidToBelongToIt) {
  Artist artist;
  artist.draw_circle({500, 500}, 200, 0);
  artist.key("Enter");
  artist.draw({{450, 520}, {400, 525}});
  artist.draw({{550, 520}, {600, 525}});
  artist.messages.clear();
  artist.key("Enter");
  ASSERT_EQ(artist.messages.size(), 1U);
  EXPECT_EQ(artist.messages.back().word, Word::LaidOnParts);
  EXPECT_EQ(artist.messages.back().arguments, std::vector<std::string>{"2"});
  EXPECT_TRUE(artist.document().loose.is_empty());
  artist.act("undo");
  EXPECT_EQ(artist.document().loose.size(), 2);
}

TEST(DrawHandlers, NoGapIsSaidToo) {
  Artist artist;
  artist.draw_circle({500, 500}, 200, 0);
  artist.key("Enter");
  EXPECT_TRUE(artist.has_said(Word::ClosedNoGap));
}

TEST(DrawHandlers, TheGapLimitsWhatIsClosed) {
  Artist artist;
  artist.draw_circle({500, 500}, 200, 40);
  artist.act("gap", "10");
  EXPECT_EQ(artist.state().choice.gap_px, 10);
  artist.key("Enter");
  EXPECT_TRUE(artist.has_said(Word::NotClosed));
  artist.act("gap", "auto");
  EXPECT_FALSE(artist.state().choice.gap_px);
  artist.key("Enter");
  EXPECT_EQ(artist.document().layers->size(), 1U);
}

TEST(DrawHandlers, ADraggedGapIsOneEntry) {
  Artist artist;
  artist.draw_circle({500, 500}, 200);
  int const before = artist.engine().history().position();
  for (auto const* const gap : {"10", "20", "30"}) artist.act("gap", gap);
  EXPECT_EQ(artist.engine().history().position(), before + 1);
}

TEST(DrawHandlers, GapsThatAreNoneAreRefused) {
  Artist artist;
  for (auto const* const gap : {"", "0", "-5", "wide", "nan"}) {
    artist.messages.clear();
    artist.act("gap", gap);
    EXPECT_TRUE(artist.has_said(Word::CannotDo)) << gap;
  }
}

TEST(DrawHandlers, ASelectedPartIsClosedAnewWithAnotherGap) {
  Artist artist;
  draw_u(artist);
  artist.key("Enter");
  artist.act("select_all");
  int const before = artist.engine().history().position();
  artist.act("gap", "150");
  artist.act("gap", "120");
  EXPECT_EQ(artist.engine().history().position(), before + 1);
  EXPECT_EQ(artist.document().layers->at(0)->layer.choice.gap_px, 120);
  EXPECT_FALSE(artist.document().layers->at(0)->layer.is_open);
}

TEST(DrawHandlers, AGapThatHasTornAPartApartPutsItTogetherAgain) {
  Artist artist;
  // Two discs whose strokes go over from one to the other.
  artist.draw({{500, 400}, {300, 300}, {300, 700}, {500, 600}});
  artist.draw({{520, 600}, {700, 700}, {700, 300}, {520, 400}});
  artist.key("Enter");
  ASSERT_EQ(artist.document().layers->size(), 1U);
  double const before = area(artist);
  artist.act("select_all");
  artist.act("gap", "300");
  artist.act("gap", "200");
  artist.act("gap", "60");
  EXPECT_EQ(artist.document().layers->at(0)->strokes.size(), 2);
  EXPECT_NEAR(area(artist), before, 0.01 * before);
}

TEST(DrawHandlers, AMarkOutsideOpensABayAndAMarkInsideFillsIt) {
  Artist artist;
  draw_u(artist);
  artist.key("Enter");
  ASSERT_EQ(artist.document().layers->size(), 1U);
  artist.act("mark_inside", "500,450");
  double const filled = area(artist);
  artist.act("mark_inside", "500,450");  // there again: taken away
  EXPECT_TRUE(artist.document().layers->at(0)->layer.choice.inside.empty());
  artist.key("o");
  artist.click({500, 450});
  double const open = area(artist);
  EXPECT_GT(filled, open + 30'000);
  EXPECT_NEAR(open, 160'000 - 60'000, 6'000);
}

TEST(DrawHandlers, MarksOnRoughStrokesWaitForEnter) {
  Artist artist;
  draw_u(artist);
  artist.act("mark_outside", "500,450");
  EXPECT_EQ(artist.state().choice.outside.size(), 1U);
  artist.key("Enter");
  auto const& layer = artist.document().layers->at(0)->layer;
  EXPECT_EQ(layer.choice.outside.size(), 1U);
  EXPECT_NEAR(area(artist), 160'000 - 60'000, 6'000);
}

TEST(DrawHandlers, MarksOfAnOpenPartAreItsOwn) {
  Artist artist;
  draw_u(artist);
  artist.key("Enter");
  artist.act("select_all");
  artist.act("open_part");
  artist.act("mark_outside", "500,450");
  EXPECT_EQ(artist.document().layers->at(0)->layer.choice.outside.size(), 1U);
  EXPECT_TRUE(artist.state().choice.outside.empty());
  artist.act("gap", "50");
  EXPECT_EQ(artist.document().layers->at(0)->layer.choice.gap_px, 50);
}

TEST(DrawHandlers, MarksNeedAPlaceAndSomethingToMark) {
  Artist artist;
  artist.act("mark_outside", "over there");
  EXPECT_TRUE(artist.has_said(Word::CannotDo));
  artist.act("mark_inside", "5,5");
  EXPECT_TRUE(artist.has_said(Word::NothingRough));
}

TEST(DrawHandlers, AMarkThatWouldLeaveNothingIsSaidAndChangesNothing) {
  Artist artist;
  artist.draw_circle({500, 500}, 200);
  artist.key("Enter");
  double const before = area(artist);
  artist.act("mark_outside", "500,500");
  EXPECT_TRUE(artist.has_said(Word::CannotDo) || area(artist) != before);
  EXPECT_FALSE(artist.document().layers->at(0)->layer.is_open);
}

TEST(DrawHandlers, SimplifyCanBeCancelled) {
  bool is_cancelled = false;
  Artist artist({{}, [&] { return is_cancelled; }});
  artist.draw_circle({500, 500}, 200);
  is_cancelled = true;
  artist.key("Enter");
  EXPECT_TRUE(artist.has_said(Word::Cancelled));
  EXPECT_EQ(artist.document().loose.size(), 2);
}

}  // namespace
}  // namespace inkflate
