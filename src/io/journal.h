// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "document/command.h"
#include "document/history.h"

namespace inkflate {

/// What was done to a document, in lines that are appended as it happens, so that work survives the end of the program. Every line
/// begins with a check sum and ends with a line break; a line that was torn at the end is as if it had never been begun.

/// One entry of the history.
struct JournalDo {
  std::vector<Command> commands;
  int label = -1;  // -1 or more
};
struct JournalUndo {};
struct JournalRedo {};
using JournalEntry = std::variant<JournalDo, JournalUndo, JournalRedo>;

/// The first line of every journal.
std::string journal_start();
std::string journal_line(JournalEntry const& entry);

/// More lines than anybody draws; each may hold another document.
inline constexpr int kMostJournalLines = 200'000;

struct ReadJournal {
  History history;  // starts with the empty document
  int entries = 0;  // that were read
  std::size_t bytes =
      0;  // up to the end of the last whole line: cut the file there before appending
  bool is_damaged =
      false;  // something follows that is not the torn end of one line; it was left out
};

/// Whether the bytes begin as a journal does.
bool is_journal(std::span<std::byte const> bytes);

/// Does again what a journal tells, as far as it is whole. A line whose sum is wrong, that is no entry or that the document refuses
/// ends it.
///
/// errors  BadInput (not a journal), Unsupported (of a newer version), TooLarge (kMostJournalLines)
/// cost    O(bytes + what the commands cost)
Result<ReadJournal> read_journal(std::span<std::byte const> bytes);

}  // namespace inkflate
