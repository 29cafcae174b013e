// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "document/history.h"
#include "io/journal.h"

namespace inkflate {

/// What is to be appended to a journal.
struct JournalText {
  std::string text;
  bool is_new = false;  // the journal starts anew with this text
};

/// Writes the journal of a history: read again, it gives the document that is current now, at any time.
///
/// A journal that has become too long to be read again begins anew with the document as it is. Then it knows nothing of what was
/// before; where the history goes back there, the journal has the document itself instead of a step.
class JournalKeeper {
 public:
  /// Reading back a longer journal would take too long.
  static constexpr long long kLongestBytes = 32LL << 20U;

  /// longest_bytes: of the journal before it begins anew, > 0
  explicit JournalKeeper(long long longest_bytes = kLongestBytes) : longest_bytes_(longest_bytes) {}

  /// in      entry: what has just been done to the history, which began with the empty document
  JournalText add(JournalEntry const& entry, History const& history);

  /// Goes on with what was read, and is the text of the journal now.
  void resume(ReadJournal const& read);

 private:
  /// Whether the journal, read again, could take the step that led to this position.
  bool can_step(JournalEntry const& entry, int position) const;
  bool is_full(std::string const& line) const;

  long long longest_bytes_ = kLongestBytes;
  long long bytes_ = 0;  // 0: not begun
  long long most_bytes_ = 0;
  int lines_ = 0;  // after the start
  int first_ = 0;  // positions of the history that undo and redo reach in the journal
  int last_ = 0;
};

}  // namespace inkflate
