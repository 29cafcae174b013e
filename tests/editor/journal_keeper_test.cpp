// SPDX-License-Identifier: Apache-2.0
#include "editor/journal_keeper.h"

#include <gtest/gtest.h>

#include <span>

#include "io/document_hash.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// A history and the file that its journal is.
class JournalKeeperTest : public testing::Test {
 protected:
  void draw(double y) { push(AddStroke{line_stroke({{0, y}, {100, y}})}); }

  void push(Command command) {
    std::vector<Command> const commands = {std::move(command)};
    ASSERT_TRUE(history.push(commands, 3).has_value());
    keep(JournalDo{commands, 3});
  }

  void undo() {
    ASSERT_TRUE(history.undo());
    keep(JournalUndo{});
  }

  void redo() {
    ASSERT_TRUE(history.redo());
    keep(JournalRedo{});
  }

  void keep(JournalEntry const& entry) {
    auto const written = keeper.add(entry, history);
    if (written.is_new) file.clear();
    file += written.text;
    starts += written.is_new ? 1 : 0;
  }

  /// So that the journal begins anew.
  void fill() {
    int const before = starts;
    for (double y = 100; starts == before; ++y) draw(y);
  }

  ReadJournal read() const {
    auto result = read_journal(std::as_bytes(std::span(file.data(), file.size())));
    EXPECT_TRUE(result.has_value());
    EXPECT_FALSE(result->is_damaged);
    return *std::move(result);
  }

  static std::uint64_t hash_of(History const& of) {
    return document_hash(to_project(of.document()));
  }

  History history{empty_document()};
  JournalKeeper keeper = JournalKeeper(4000);
  std::string file;
  int starts = 0;
};

TEST_F(JournalKeeperTest, WhatIsReadIsTheHistory) {
  for (double const y : {1, 2, 3}) draw(y);
  undo();
  undo();
  redo();
  auto const journal = read();
  EXPECT_EQ(hash_of(journal.history), hash_of(history));
  EXPECT_EQ(journal.history.position(), history.position());
  EXPECT_EQ(journal.history.size(), history.size());
  EXPECT_EQ(starts, 1);
}

TEST_F(JournalKeeperTest, AJournalThatBeganAnewFollowsUndoBehindItsBeginning) {
  draw(1);
  draw(2);
  fill();
  while (history.can_undo()) undo();
  redo();
  draw(7);
  auto const journal = read();
  EXPECT_EQ(hash_of(journal.history), hash_of(history));
}

TEST_F(JournalKeeperTest, RedoAfterABeginningInTheMiddleOfUndoIsFollowed) {
  draw(1);
  fill();
  undo();
  undo();
  redo();
  redo();
  EXPECT_EQ(hash_of(read().history), hash_of(history));
  draw(2);
  undo();
  redo();
  EXPECT_EQ(hash_of(read().history), hash_of(history));
}

TEST_F(JournalKeeperTest, WhatWasReadGoesOn) {
  draw(1);
  draw(2);
  undo();
  auto journal = read();
  keeper = JournalKeeper(4000);
  keeper.resume(journal);
  history = std::move(journal.history);
  redo();
  undo();
  undo();
  draw(3);
  EXPECT_EQ(hash_of(read().history), hash_of(history));
  EXPECT_EQ(starts, 1);
}

TEST_F(JournalKeeperTest, ManyShortLinesBeginAnewToo) {
  keeper = JournalKeeper();
  draw(1);
  for (int i = 0; i < kMostJournalLines / 2; ++i) {
    undo();
    redo();
  }
  EXPECT_EQ(starts, 2);
  EXPECT_LT(file.size(), 1000U);
  EXPECT_EQ(hash_of(read().history), hash_of(history));
}

}  // namespace
}  // namespace inkflate
