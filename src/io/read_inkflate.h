// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "base/result.h"
#include "model/project.h"

namespace inkflate {

/// Reads an .inkflate file, see docs/FORMATS.md.
///
/// errors  BadInput (damaged; index: the byte of the archive, or the stroke, group or layer), TooLarge (limits of archive, JSON
///         and pictures), Unsupported (made by a newer version; zip64)
/// cost    O(bytes + pixels)
Result<Project> read_inkflate(std::span<std::byte const> file);

}  // namespace inkflate
