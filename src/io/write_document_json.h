// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "model/project.h"

namespace inkflate {

/// The project as JSON that read_document_json gives back exactly, but for its template picture: of that only the name is kept,
/// under which it lies beside the text. Empty: there is none.
///
/// in      numbers finite and in the ranges of the model, indices in range; pieces of an outline join; names in UTF-8
///         (other bytes become U+FFFD)
/// cost    O(samples + pieces)
std::string write_document_json(Project const& project, std::string_view template_name = {});

/// The same, to become a part of other JSON.
nlohmann::ordered_json document_json(Project const& project, std::string_view template_name = {});

/// The text of JSON on one line, as all of our files have it: bytes that are no UTF-8 become U+FFFD.
std::string json_text(nlohmann::ordered_json const& json);

}  // namespace inkflate
