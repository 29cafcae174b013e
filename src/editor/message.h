// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/rect.h"

namespace inkflate {

enum class Language { English, Czech };

enum class Severity {
  Status,   // it went well: for a status line or a screen reader
  Warning,  // it went, but not as one might expect
  Problem,  // it did not go
};

/// Everything that the editor says. The texts lie in one table, words.cpp: a member for each row.
enum class Word {
  // Status
  ClosedGaps,  // {0}: how many
  ClosedNoGap,
  LaidOnParts,  // {0}: how many strokes
  CopiedBehind,
  CopiedBefore,
  CopyRemoved,
  Opened,  // {0}: a file's name
  Saved,
  Exported,
  Recovered,
  RecoveredInPart,
  PinSelected,  // {0}: which of how many, "2/5"
  Undone,       // {0}: the name of an action
  Redone,
  // Warnings and problems
  NothingRough,  // Simplify without loose strokes
  NotClosed,
  NothingToInflate,
  NothingSelected,
  SeveralSelected,  // where one part is wanted
  NoPin,            // none is selected, or there is none
  NothingToBend,    // no line to hold
  PartLocked,
  NotYetPart,  // a pin on a rough line
  NothingToUndo,
  NothingToRedo,
  CannotRead,  // {0}: a reason
  LeftOut,     // {0}: what of a file was not read
  CannotDo,    // {0}: a reason
  Cancelled,
  ModelFault,  // {0}: a reason
};

struct Message {
  Severity severity = Severity::Status;
  Word word = Word::CannotDo;
  std::vector<std::string> arguments = {};
  std::optional<Rect> place = {};  // on the canvas: where to look

  friend bool operator==(Message const&, Message const&) = default;
};

/// The message for people; plurals as the language wants them, actions by their labels. Reasons stay as they came.
std::string text_of(Message const& message, Language language);

}  // namespace inkflate
