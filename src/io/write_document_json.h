// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "io/document_file.h"

namespace inkflate {

/// The document as JSON that read_document_json gives back exactly.
///
/// in      numbers finite and in the ranges of the model, indices in range; pieces of an outline join; names in UTF-8
///         (other bytes become U+FFFD)
/// cost    O(samples + pieces)
std::string write_document_json(DocumentFile const& document);

}  // namespace inkflate
