// SPDX-License-Identifier: Apache-2.0
#include "document/history.h"

#include <cstddef>
#include <iterator>
#include <utility>

#include "document/apply.h"

namespace inkflate {

History::History(Document start) { entries_.push_back({std::move(start), -1}); }

Document const& History::document() const { return entries_[current_].document; }
bool History::can_undo() const { return current_ > 0; }
bool History::can_redo() const { return current_ + 1 < entries_.size(); }

Result<bool> History::push(std::vector<Command> const& commands, int label) {
  auto next = inkflate::apply(document(), commands);
  if (!next) return next.error();
  push(std::move(next).value(), label);
  return true;
}

void History::push(Document next, int label) {
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(current_) + 1, entries_.end());
  entries_.push_back({std::move(next), label});
  ++current_;
}

bool History::undo() {
  if (!can_undo()) return false;
  --current_;
  return true;
}

bool History::redo() {
  if (!can_redo()) return false;
  ++current_;
  return true;
}

int History::undo_label() const { return can_undo() ? entries_[current_].label : -1; }
int History::redo_label() const { return can_redo() ? entries_[current_ + 1].label : -1; }
int History::size() const { return static_cast<int>(std::ssize(entries_)) - 1; }
int History::position() const { return static_cast<int>(current_); }

}  // namespace inkflate
