// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/result.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

/// What a document may hold; docs/LIMITS.md.
struct DocumentLimits {
  static constexpr int kStrokes = 1'000'000;
  static constexpr int kSamplesOfStroke = 1'000'000;
  static constexpr int kLayers = 1024;
  static constexpr int kPins = 1024;
  static constexpr int kBendPins = 256;         // of a layer
  static constexpr double kBendTurnRad = 1000;  // of a bend pin, to either side
  static constexpr int kKeys = 100'000;         // of a track
  static constexpr int kMarks = 1024;           // of a choice, of each kind
  static constexpr double kFarthestPx = 1e6;    // of any coordinate
  static constexpr double kClipS = 86400;       // a day
  static constexpr int kIds = 2'000'000'000;    // that are ever given to layers and pins
};

/// The document after one command.
///
/// errors  BadInput (no such layer, stroke or pin; a layer that is not open; a number not finite or too large: index names the stroke,
///         layer or pin), BadOption (a value out of its range), TooLarge (DocumentLimits), NothingThere (a command that would change
///         nothing: an empty list, an eraser that meets no stroke)
/// note    call it as inkflate::apply: for a variant or a vector the language also looks into std
/// cost    O(what changes); an eraser also O(strokes that it could meet)
Result<Document> apply(Document const& document, Command const& command);

/// After all of them, in order; the first that is refused refuses all.
Result<Document> apply(Document const& document, std::span<Command const> commands);

}  // namespace inkflate
