// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/result.h"
#include "io/document_file.h"

namespace inkflate {

/// Reads document.json. Members that it does not know are passed over.
///
/// errors  BadInput (no JSON, or a value that is missing or out of its range; index: the stroke, group, layer, pin or track), TooLarge
///         (JsonLimits; samples), Unsupported (a newer version)
/// cost    O(bytes)
Result<DocumentFile> read_document_json(std::string_view text);

/// The same, where it is a part of other JSON.
Result<DocumentFile> take_document(nlohmann::json const& json);

}  // namespace inkflate
