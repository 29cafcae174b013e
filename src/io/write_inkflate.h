// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "model/project.h"

namespace inkflate {

/// A project as .inkflate file: a zip archive, see docs/FORMATS.md. read_inkflate gives back exactly the same; the same bytes for
/// the same project on every machine.
///
/// in      numbers finite and in the ranges of the model, coordinates within 1e6, indices in range; pieces of an outline
///         join; names in UTF-8; a template picture has pixels
/// errors  TooLarge (the file would be larger than we read)
/// cost    O(samples + pieces + pixels)
Result<std::vector<std::byte>> write_inkflate(Project const& project);

}  // namespace inkflate
