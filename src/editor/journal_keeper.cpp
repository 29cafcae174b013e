// SPDX-License-Identifier: Apache-2.0
#include "editor/journal_keeper.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace inkflate {
namespace {

/// A document that is long itself must not be written again with every entry.
constexpr long long kGrowth = 2;

}  // namespace

bool JournalKeeper::can_step(JournalEntry const& entry, int position) const {
  return std::holds_alternative<JournalDo>(entry) || (first_ <= position && position <= last_);
}

bool JournalKeeper::is_full(std::string const& line) const {
  return bytes_ + std::ssize(line) > std::max(longest_bytes_, most_bytes_) ||
         lines_ >= kMostJournalLines;
}

JournalText JournalKeeper::add(JournalEntry const& entry, History const& history) {
  int const position = history.position();
  bool const is_first = bytes_ == 0;
  bool const is_step = can_step(entry, position);
  auto line = is_step ? journal_line(entry) : std::string();
  bool const begins_anew = !is_first && is_full(line);
  bool const is_whole = begins_anew || !is_step;
  if (is_whole) {
    line = journal_line(JournalDo{{Replace{history.document()}}, history.undo_label()});
    first_ = position;
  }
  if (is_whole || std::holds_alternative<JournalDo>(entry)) last_ = position;
  JournalText result = {std::move(line), is_first || begins_anew};
  if (result.is_new) {
    result.text.insert(0, journal_start());
    bytes_ = 0;
    lines_ = 0;
    most_bytes_ = kGrowth * std::ssize(result.text);
  }
  bytes_ += std::ssize(result.text);
  ++lines_;
  return result;
}

void JournalKeeper::resume(ReadJournal const& read) {
  bytes_ = static_cast<long long>(read.bytes);
  most_bytes_ = 0;
  lines_ = read.entries;
  first_ = 0;
  last_ = read.history.size();
}

}  // namespace inkflate
