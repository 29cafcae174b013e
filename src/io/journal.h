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
/// ends with a check sum and a line break; a line that was torn at the end is as if it had never been begun.

/// One entry of the history.
struct JournalDo {
  std::vector<Command> commands;
  int label = -1;
};
struct JournalUndo {};
struct JournalRedo {};
using JournalEntry = std::variant<JournalDo, JournalUndo, JournalRedo>;

/// The first line of every journal.
std::string journal_start();
std::string journal_line(JournalEntry const& entry);

struct ReadJournal {
  History history;  // starts with the empty document
  int entries = 0;  // that were read
  std::size_t bytes =
      0;  // up to the end of the last whole line: cut the file there before appending
  bool is_damaged =
      false;  // something follows that is not the torn end of one line; it was left out
};

/// Does again what a journal tells, as far as it is whole.
///
/// errors  BadInput (not a journal), Unsupported (of a newer version), TooLarge
/// cost    O(bytes + what the commands cost)
Result<ReadJournal> read_journal(std::span<std::byte const> bytes);

}  // namespace inkflate
