// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "base/result.h"
#include "io/document_file.h"

namespace inkflate {

/// Reads document.json. Members that it does not know are passed over.
///
/// errors  BadInput (no JSON, or a value that is missing or out of its range; index: the stroke, group or layer), TooLarge
///         (JsonLimits; samples), Unsupported (a newer version)
/// cost    O(bytes)
Result<DocumentFile> read_document_json(std::string_view text);

}  // namespace inkflate
