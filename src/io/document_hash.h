// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/project.h"

namespace inkflate {

/// A number for what was made by hand, equal on every machine: of document.json's text and of the pixels of its pictures. Two
/// documents that are written alike have the same.
std::uint64_t document_hash(Project const& project);

}  // namespace inkflate
