// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <span>

#include "base/rng.h"
#include "editor/engine.h"
#include "io/journal.h"
#include "io/read_document.h"
#include "io/write_png.h"
#include "support/artist.h"

namespace inkflate {
namespace {

constexpr Vec2 kMiddle = {500, 500};

std::vector<std::byte> bytes_of(std::string const& text) {
  auto const bytes = std::as_bytes(std::span(text.data(), text.size()));
  return {bytes.begin(), bytes.end()};
}

Artist with_disc() {
  Artist artist;
  artist.draw_circle(kMiddle, 200);
  artist.key("Enter");
  return artist;
}

FileEvent file_of(FileOut const& file, FileUse use = FileUse::Open) {
  return {file.bytes, file.name, use};
}

TEST(EngineFiles, WhatIsSavedOpensAsTheSame) {
  auto artist = with_disc();
  artist.draw({{100, 100}, {200, 100}});
  EXPECT_FALSE(artist.state().is_saved);
  artist.key("s", {.is_ctrl = true});
  EXPECT_TRUE(artist.state().is_saved);
  ASSERT_EQ(artist.files.size(), 1U);
  EXPECT_EQ(artist.files[0].name, "drawing.inkflate");
  Artist other;
  other.send(file_of(artist.files[0]));
  EXPECT_EQ(other.hash(), artist.hash());
  EXPECT_TRUE(other.state().is_saved);
  EXPECT_TRUE(other.has_said(Word::Opened));
}

TEST(EngineFiles, OpeningCanBeUndone) {
  auto artist = with_disc();
  artist.act("save");
  auto const file = artist.files[0];
  artist.draw({{100, 100}, {200, 100}});
  auto const before = artist.hash();
  artist.send(file_of(file));
  EXPECT_NE(artist.hash(), before);
  artist.act("undo");
  EXPECT_EQ(artist.hash(), before);
  EXPECT_FALSE(artist.state().is_saved);
}

TEST(EngineFiles, NewCanBeUndone) {
  auto artist = with_disc();
  auto const before = artist.hash();
  artist.act("new");
  EXPECT_TRUE(is_blank(artist.document()));
  artist.act("undo");
  EXPECT_EQ(artist.hash(), before);
  Artist fresh;
  fresh.act("new");
  EXPECT_FALSE(fresh.engine().history().can_undo());
}

TEST(EngineFiles, AddedDrawingsComeInFrontAndKeepWhatIsThere) {
  auto artist = with_disc();
  artist.act("save");
  artist.send(file_of(artist.files[0], FileUse::Add));
  auto const& layers = *artist.document().layers;
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_NE(layers[0]->layer.id, layers[1]->layer.id);
  EXPECT_EQ(layers[0]->strokes.size(), layers[1]->strokes.size());
}

TEST(EngineFiles, StrokesOfASketchOpenAsRough) {
  std::string const svg =
      "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>"
      "<path d='M10 10 L90 10 L90 90 L10 90 Z' stroke='black' fill='none'/></svg>";
  auto const bytes = bytes_of(svg);
  Artist artist;
  artist.send(FileEvent{bytes, "some/square.svg", FileUse::Open});
  EXPECT_TRUE(artist.state().has_rough_strokes);
  EXPECT_EQ(artist.state().file_name, "square");
  artist.key("Enter");
  EXPECT_EQ(artist.document().layers->size(), 1U);
}

TEST(EngineFiles, AScanOpensAsItsStrokes) {
  Picture paper(200, 200, {255, 255, 255});
  for (int i = 40; i < 160; ++i) {
    for (int k = 0; k < 3; ++k) {
      paper.at(i, 40 + k) = paper.at(i, 157 + k) = {0, 0, 0};
      paper.at(40 + k, i) = paper.at(157 + k, i) = {0, 0, 0};
    }
  }
  Artist artist;
  artist.send(FileEvent{write_png(paper), "scan.png", FileUse::Open});
  EXPECT_TRUE(artist.state().has_rough_strokes);
  Artist blank;
  blank.send(FileEvent{write_png(Picture(64, 64, {255, 255, 255})), "blank.png", FileUse::Open});
  EXPECT_TRUE(blank.has_said(Word::CannotRead));
}

TEST(EngineFiles, AFileThatIsNoneIsSaidAndChangesNothing) {
  auto artist = with_disc();
  auto const before = artist.hash();
  for (auto const use : {FileUse::Open, FileUse::Add, FileUse::Template}) {
    artist.messages.clear();
    auto const bytes = bytes_of("this is a letter");
    artist.send(FileEvent{bytes, "letter.txt", use});
    EXPECT_TRUE(artist.has_said(Word::CannotRead));
  }
  EXPECT_EQ(artist.hash(), before);
}

TEST(EngineFiles, ATemplateIsPutUnderTheDrawingAndTakenAway) {
  Artist artist;
  artist.send(FileEvent{write_png(Picture(20, 10, {200, 30, 30})), "t.png", FileUse::Template});
  ASSERT_TRUE(artist.document().template_picture);
  EXPECT_EQ(artist.document().template_picture->width, 20);
  artist.act("remove_template");
  EXPECT_FALSE(artist.document().template_picture);
}

TEST(EngineFiles, EveryFormatIsExported) {
  auto artist = with_disc();
  for (auto const* const extension : {"inkflate", "svg", "png", "zip", "glb", "stl", "3mf"}) {
    artist.files.clear();
    artist.act("export_as", extension);
    ASSERT_EQ(artist.files.size(), 1U) << extension;
    EXPECT_EQ(artist.files[0].name, std::string("drawing.") + extension);
    EXPECT_FALSE(artist.files[0].bytes.empty());
  }
  artist.files.clear();
  artist.act("export_as", "obj");
  ASSERT_EQ(artist.files.size(), 3U);
  EXPECT_EQ(artist.files.back().name, "drawing.obj");
}

TEST(EngineFiles, APictureShowsTheModelWhereThatIsLookedAt) {
  auto artist = with_disc();
  artist.act("export_as", "png");
  artist.key("2");
  artist.act("export_as", "png");
  ASSERT_EQ(artist.files.size(), 2U);
  EXPECT_NE(artist.files[0].bytes, artist.files[1].bytes);
}

TEST(EngineFiles, WhatCannotBeExportedIsSaid) {
  auto artist = with_disc();
  artist.act("export_as", "fbx");
  EXPECT_TRUE(artist.has_said(Word::CannotDo));
  Artist empty;
  empty.act("export_as", "glb");
  EXPECT_TRUE(empty.has_said(Word::CannotDo));
  EXPECT_TRUE(empty.files.empty());
}

TEST(EngineFiles, TheJournalGivesTheDocumentBackWithItsHistory) {
  auto artist = with_disc();
  artist.draw({{100, 100}, {200, 100}});
  artist.act("undo");
  artist.draw({{100, 100}, {200, 300}});
  auto const end = artist.hash();
  Artist next;
  auto const changes = next.engine().recover(bytes_of(artist.journal));
  EXPECT_EQ(next.hash(), end);
  EXPECT_TRUE(changes.is_journal_new);
  EXPECT_EQ(changes.journal, artist.journal);
  EXPECT_FALSE(next.state().is_saved);
  next.act("undo");
  next.act("undo");
  EXPECT_TRUE(next.state().has_rough_strokes);
}

TEST(EngineFiles, ADrawingThatIsTakenUpIsCalledAsBefore) {
  auto artist = with_disc();
  Artist next;
  next.engine().recover(bytes_of(artist.journal), "hand.of.mine");
  EXPECT_EQ(next.state().file_name, "hand.of.mine");
  EXPECT_EQ(next.act("save").files.at(0).name, "hand.of.mine.inkflate");
  next.engine().recover(bytes_of(artist.journal));
  EXPECT_EQ(next.state().file_name, "drawing");
}

TEST(EngineFiles, ATornJournalIsTakenUpAtItsLastWholeLine) {
  auto artist = with_disc();
  auto const whole = artist.journal.size();
  auto const before = artist.hash();
  artist.draw({{100, 100}, {200, 100}});
  auto const torn = artist.journal.substr(0, whole + 20);
  Artist next;
  auto const changes = next.engine().recover(bytes_of(torn));
  EXPECT_EQ(next.hash(), before);
  EXPECT_EQ(changes.journal.size(), whole);
}

TEST(EngineFiles, AJournalThatIsDamagedInTheMiddleIsSaidToBe) {
  auto artist = with_disc();
  auto const whole = artist.journal.size();
  artist.draw({{100, 100}, {200, 100}});
  artist.draw({{100, 100}, {200, 300}});
  artist.journal[whole + 30] ^= 1;
  Artist next;
  auto const changes = next.engine().recover(bytes_of(artist.journal));
  ASSERT_EQ(changes.messages.size(), 1U);
  EXPECT_EQ(changes.messages[0].word, Word::RecoveredInPart);
  EXPECT_EQ(changes.messages[0].severity, Severity::Warning);
  EXPECT_EQ(changes.journal.size(), whole);
}

TEST(EngineFiles, RecoveryBeginsWithoutASelection) {
  auto const artist = with_disc();
  auto next = with_disc();
  next.act("select_all");
  next.engine().recover(bytes_of(artist.journal));
  EXPECT_TRUE(next.state().view.selection.empty());
}

TEST(EngineFiles, RecoveryInTheMiddleOfALineDropsTheLine) {
  auto const artist = with_disc();
  Artist next;
  next.press({100, 100});
  next.move({200, 200});
  next.engine().recover(bytes_of(artist.journal));
  next.move({300, 200});
  next.release({300, 200});
  EXPECT_EQ(next.hash(), artist.hash());
}

TEST(EngineFiles, OpeningInTheMiddleOfALineDropsTheLine) {
  auto artist = with_disc();
  artist.act("save");
  Artist next;
  next.press({100, 100});
  next.move({200, 200});
  next.send(file_of(artist.files.at(0)));
  next.move({300, 200});
  next.release({300, 200});
  EXPECT_EQ(next.hash(), artist.hash());
}

TEST(EngineFiles, WhatOfAFileWasLeftOutIsSaid) {
  Artist artist;
  std::string const svg = R"(<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">)"
                          R"(<text>words</text><path d="M1 1 L8 8" stroke="black"/></svg>)";
  auto const bytes = bytes_of(svg);
  artist.send(FileEvent{bytes, "a.svg"});
  EXPECT_TRUE(artist.has_said(Word::LeftOut));
}

TEST(EngineFiles, WhatIsTooMuchForOneDrawingIsNotAdded) {
  Artist artist;
  artist.draw_circle(kMiddle, 100);
  artist.key("Enter");
  artist.key("a", {.is_ctrl = true});
  for (int i = 0; i < 9; ++i) {
    artist.key("d", {.is_ctrl = true});
    artist.key("a", {.is_ctrl = true});
  }
  ASSERT_EQ(artist.document().layers->size(), 512U);
  artist.act("save");
  artist.key("d", {.is_ctrl = true});
  auto const before = artist.hash();
  artist.send(file_of(artist.files.at(0), FileUse::Add));
  EXPECT_TRUE(artist.has_said(Word::CannotDo));
  EXPECT_EQ(artist.hash(), before);
}

TEST(EngineFiles, WhatIsNoJournalIsSaid) {
  Artist artist;
  auto const changes = artist.engine().recover(bytes_of("once upon a time"));
  ASSERT_EQ(changes.messages.size(), 1U);
  EXPECT_EQ(changes.messages[0].word, Word::CannotRead);
  EXPECT_FALSE(changes.is_journal_new);
}

TEST(EngineFiles, ALongJournalBeginsAnew) {
  Artist artist;
  artist.draw({{100, 100}, {200, 100}});
  // Every template is written into the journal as a picture; noise does not pack.
  Rng rng(7);
  Picture noise(1500, 1500, {});
  for (auto& value : noise.values) {
    auto const bits = rng.bits();
    value = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8U),
             static_cast<std::uint8_t>(bits >> 16U)};
  }
  auto const file = FileEvent{write_png(noise), "noise.png", FileUse::Template};
  for (int i = 0; i < 4; ++i) artist.send(file);
  artist.act("remove_template");
  EXPECT_LT(artist.journal.size(), 33U << 20U);
  EXPECT_GT(artist.journal.size(), 100U);
  Artist next;
  next.engine().recover(bytes_of(artist.journal));
  EXPECT_EQ(next.hash(), artist.hash());
}

}  // namespace
}  // namespace inkflate
