// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/run_simplify.h"

namespace inkflate::cli {

/// What a file holds for simplify, whatever its format.
struct ReadSketch {
  SketchSource source;
  std::vector<std::string> warnings;  // what of the file was left out
};

/// Reads strokes (SVG, .scap) or a scan (PNG, JPEG), by what the bytes are, not by a name.
///
/// errors  those of the readers; Unsupported (another format)
Result<ReadSketch> read_sketch(std::span<std::byte const> content);

}  // namespace inkflate::cli
