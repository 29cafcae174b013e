// SPDX-License-Identifier: Apache-2.0
#include "io/journal.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "io/bytes.h"
#include "io/document_hash.h"
#include "io/numbers.h"
#include "support/random_commands.h"

namespace inkflate {
namespace {

// A triangle drawn twice, closed once, pinned, moved; now and then taken back.
std::vector<JournalEntry> story() {
  auto const line = [](Vec2 a, Vec2 b) {
    return AddStroke{Stroke{{{a}, {b}}, StrokeKind::Ink, 2, {}}};
  };
  Vec2 const corners[] = {{100, 100}, {300, 100}, {200, 300}};
  Outline outline;
  for (int i = 0; i < 3; ++i) {
    outline.pieces.push_back({line_cubic(corners[i], corners[(i + 1) % 3])});
  }
  Layer shape = {"body", {outline}, {0, 1}, {}};
  return {JournalDo{{line(corners[0], corners[1])}, 0},
          JournalDo{{line(corners[1], corners[2])}, 0},
          JournalUndo{},
          JournalRedo{},
          JournalDo{{Simplify{{{LayerId::None, {0, 1}, StrokeDepth::Near, {shape}}}}}, 1},
          JournalDo{{SetThickness{LayerId{1}, 3}, RenameLayer{LayerId{1}, "b\xc3\xa4r"}}, 2},
          JournalDo{{AddPin{{PinId::None, LayerId{1}, Side::Back, {150, 150}, {150, 150}}}}, -1},
          JournalUndo{},
          JournalUndo{},
          JournalDo{{SetCanvas{640, 480}}, 3}};
}

struct Told {
  std::string text = journal_start();
  std::vector<std::uint64_t> hashes = {document_hash(to_project(empty_document()))};  // per entry
};

std::uint64_t hash_of(History const& history) {
  return document_hash(to_project(history.document()));
}

Told tell() {
  Told told;
  for (auto const& entry : story()) {
    told.text += journal_line(entry);
    auto const read = read_journal(as_bytes(told.text));
    EXPECT_TRUE(read.has_value() && !read->is_damaged);
    if (read) told.hashes.push_back(hash_of(read->history));
  }
  return told;
}

TEST(Journal, TellsTheWholeHistory) {
  auto const told = tell();
  auto const read = read_journal(as_bytes(told.text));
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_FALSE(read->is_damaged);
  EXPECT_EQ(read->entries, 10);
  EXPECT_EQ(read->bytes, told.text.size());
  History expected(empty_document());
  for (auto const& entry : story()) {
    if (auto const* const done = std::get_if<JournalDo>(&entry)) {
      ASSERT_TRUE(expected.push(done->commands, done->label).has_value());
    } else {
      EXPECT_TRUE(std::holds_alternative<JournalUndo>(entry) ? expected.undo() : expected.redo());
    }
  }
  auto history = read->history;
  EXPECT_EQ(history.size(), expected.size());
  EXPECT_EQ(history.position(), expected.position());
  for (bool is_first = true; is_first || (history.undo() && expected.undo()); is_first = false) {
    EXPECT_EQ(to_project(history.document()), to_project(expected.document()));
    EXPECT_EQ(history.undo_label(), expected.undo_label());
  }
  EXPECT_FALSE(expected.can_undo());
}

TEST(Journal, GoesThroughTheSameDocuments) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Rng rng(seed);
    History history(empty_document());
    std::string text = journal_start();
    for (int i = 0; i < 30; ++i) {
      int const step = rng.below(6);
      if (step == 0 && history.undo()) text += journal_line(JournalUndo{});
      if (step == 1 && history.redo()) text += journal_line(JournalRedo{});
      if (step < 2) continue;
      JournalDo const entry = {{test::random_command(rng, history.document())}, i};
      if (history.push(entry.commands, entry.label)) text += journal_line(entry);
    }
    auto const read = read_journal(as_bytes(text));
    ASSERT_TRUE(read.has_value() && !read->is_damaged);
    EXPECT_EQ(read->history.position(), history.position());
    EXPECT_EQ(read->history.size(), history.size());
    EXPECT_EQ(to_project(read->history.document()), to_project(history.document()));
  }
}

TEST(Journal, AStartAloneIsAnEmptyDocument) {
  auto const read = read_journal(as_bytes(journal_start()));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->entries, 0);
  EXPECT_EQ(read->bytes, journal_start().size());
  EXPECT_EQ(to_project(read->history.document()), to_project(empty_document()));
}

// Gives the entries that were read; they are the first of those told, whatever happened to the rest.
int expect_beginning(Told const& told, ReadJournal const& read) {
  EXPECT_LT(static_cast<std::size_t>(read.entries), told.hashes.size());
  EXPECT_EQ(hash_of(read.history), told.hashes[static_cast<std::size_t>(read.entries)]);
  return read.entries;
}

TEST(Journal, TornAnywhereItTellsTheBeginning) {
  auto const told = tell();
  int before = 0;
  for (std::size_t size = 0; size < told.text.size(); ++size) {
    auto const read = read_journal(as_bytes(told.text.substr(0, size)));
    if (size < journal_start().size()) {
      EXPECT_EQ(read.error().code, ErrorCode::BadInput);
      continue;
    }
    ASSERT_TRUE(read.has_value());
    EXPECT_FALSE(read->is_damaged);
    int const entries = expect_beginning(told, *read);
    EXPECT_TRUE(entries == before || entries == before + 1);
    EXPECT_LE(read->bytes, size);
    // What is left can be gone on with.
    EXPECT_EQ(told.text[read->bytes - 1], '\n');
    before = entries;
  }
  EXPECT_EQ(before, 9);
}

TEST(Journal, AFalseByteAnywhereLeavesTheBeginning) {
  auto const told = tell();
  for (std::size_t i = 0; i < told.text.size(); ++i) {
    auto damaged = told.text;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << (i % 7)));
    auto const read = read_journal(as_bytes(damaged));
    if (!read) {
      EXPECT_LT(i, journal_start().size());
      EXPECT_EQ(read.error().code, ErrorCode::BadInput);
      continue;
    }
    EXPECT_LT(expect_beginning(told, *read), 10);
    EXPECT_LE(read->bytes, i);
  }
}

TEST(Journal, ADamagedLineEndsItAndIsTold) {
  auto const told = tell();
  auto const second = told.text.find('\n', journal_start().size()) + 1;
  for (std::string const& line :
       {std::string("\n"), std::string("x\n"), std::string(17, '0') + "\n",
        std::string("0000000000000000 {}\n"), std::string(3, '\0') + "\n"}) {
    auto damaged = told.text;
    damaged.insert(second, line);
    auto const read = read_journal(as_bytes(damaged));
    ASSERT_TRUE(read.has_value());
    EXPECT_TRUE(read->is_damaged) << line;
    EXPECT_EQ(read->entries, 1);
    EXPECT_EQ(read->bytes, second);
  }
}

/// With the sum that it should have.
std::string line_of(std::string const& text) {
  Hash hash;
  hash.add(as_bytes(text));
  return hex_digits(hash.value()) + " " + text + "\n";
}

TEST(Journal, WhatIsNoEntryOrIsRefusedEndsIt) {
  for (auto const* const text :
       {"", "{}", "[]", "{\"entry\":\"do\"}", "{\"entry\":\"go\"}", "{\"entry\":1}",
        "{\"entry\":\"undo\"}", "{\"entry\":\"redo\"}",
        "{\"entry\":\"do\",\"label\":-2,\"commands\":[]}",
        "{\"entry\":\"do\",\"label\":0,\"commands\":{}}",
        "{\"entry\":\"do\",\"label\":0,\"commands\":[{\"command\":\"dance\"}]}",
        "{\"entry\":\"do\",\"label\":0,\"commands\":[{\"command\":\"open_layer\",\"layer\":1}]}"}) {
    auto const lines = journal_start() + line_of(text);
    auto const read = read_journal(as_bytes(lines));
    ASSERT_TRUE(read.has_value());
    EXPECT_TRUE(read->is_damaged) << text;
    EXPECT_EQ(read->entries, 0);
    EXPECT_EQ(read->bytes, journal_start().size());
  }
}

TEST(Journal, OtherFilesAndNewerVersionsAreRefused) {
  auto const code = [](std::string const& text) {
    return read_journal(as_bytes(text)).error().code;
  };
  EXPECT_EQ(code(""), ErrorCode::BadInput);
  EXPECT_EQ(code("\n"), ErrorCode::BadInput);
  EXPECT_EQ(code("<svg/>\n"), ErrorCode::BadInput);
  EXPECT_EQ(code(line_of("{\"format\":\"inkflate\",\"version\":1}")), ErrorCode::BadInput);
  EXPECT_EQ(code(line_of("{\"format\":\"inkflate journal\",\"version\":0}")), ErrorCode::BadInput);
  EXPECT_EQ(code(line_of("{\"format\":\"inkflate journal\"")), ErrorCode::BadInput);
  EXPECT_EQ(code(line_of("{\"format\":\"inkflate journal\",\"version\":2}")),
            ErrorCode::Unsupported);
  EXPECT_EQ(code(journal_start() + std::string(kMostJournalLines + 1, '\n')), ErrorCode::TooLarge);
}

TEST(Journal, ItsLinesAreAsTheyAreSpecified) {
  EXPECT_EQ(journal_start(), line_of(R"({"format":"inkflate journal","version":1})"));
  EXPECT_EQ(journal_line(JournalUndo{}), line_of(R"({"entry":"undo"})"));
  EXPECT_EQ(journal_line(JournalRedo{}), line_of(R"({"entry":"redo"})"));
  EXPECT_EQ(
      journal_line(JournalDo{{DeletePins{{PinId{7}}}}, 12}),
      line_of(R"({"entry":"do","label":12,"commands":[{"command":"delete_pins","pins":[7]}]})"));
}

}  // namespace
}  // namespace inkflate
