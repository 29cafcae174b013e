// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/project.h"

namespace inkflate {

/// A number for what was made by hand, equal on every machine: of document.json's text and of the pixels of its pictures. Two
/// documents that are written alike have the same, whatever kind of file they came from; how a picture was packed does not matter.
///
/// in      as write_document_json
/// cost    O(samples + pieces + pixels)
std::uint64_t document_hash(Project const& project);

}  // namespace inkflate
