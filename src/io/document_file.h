// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "model/drawing.h"

namespace inkflate {

/// What document.json holds. Pictures lie beside it, as files of the same archive.
struct DocumentFile {
  Drawing drawing;
  std::string template_name = {};  // of the template picture's file; empty: none

  friend bool operator==(DocumentFile const&, DocumentFile const&) = default;
};

/// How document.json is known, and the version that we write: also the newest that we read. docs/FORMATS.md tells what is in it.
inline constexpr std::string_view kDocumentFormat = "inkflate";
inline constexpr int kDocumentVersion = 1;

/// The words of document.json.
inline std::string_view word(StrokeKind kind) { return kind == StrokeKind::Ink ? "ink" : "help"; }
inline std::string_view word(RunKind kind) {
  return kind == RunKind::Ink ? "ink" : kind == RunKind::HelpLine ? "help" : "closing";
}

}  // namespace inkflate
