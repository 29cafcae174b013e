// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "base/result.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

/// Every document from the first to the last, sharing what they have in common, and the one that is current. Without limit.
class History {
 public:
  explicit History(Document start);

  Document const& document() const;
  bool can_undo() const;
  bool can_redo() const;

  /// One entry: the document that these commands make becomes the current one, and what was undone is gone. label: what undo
  /// will say that it takes back; an index of the caller's (editor: of its words).
  ///
  /// errors  those of apply; then nothing has changed
  Result<bool> push(std::vector<Command> const& commands, int label);

  /// The same for a document that the caller has already made of the current one.
  void push(Document next, int label);

  /// False: there was nothing to undo or redo.
  bool undo();
  bool redo();

  int undo_label() const;  // -1: nothing to undo
  int redo_label() const;

  int size() const;      // entries, those undone included
  int position() const;  // entries done: 0 .. size()

 private:
  struct Entry {
    Document document;
    int label = -1;  // of the step that made it; -1: the start
  };

  std::deque<Entry>
      entries_;  // the start first; a vector would hold twice its memory while it grows
  std::size_t current_ = 0;
};

}  // namespace inkflate
