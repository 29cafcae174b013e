// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "model/project.h"

namespace inkflate {

/// What document.json holds. Pictures lie beside it, as files of the same archive.
struct DocumentFile {
  Project project;                 // without its template picture
  std::string template_name = {};  // of the template picture's file; empty: none

  friend bool operator==(DocumentFile const&, DocumentFile const&) = default;
};

/// How document.json is known, and the version that we write: also the newest that we read. docs/FORMATS.md tells what is in it.
inline constexpr std::string_view kDocumentFormat = "inkflate";
inline constexpr int kDocumentVersion = 1;

}  // namespace inkflate
