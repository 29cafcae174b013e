// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/grid2.h"
#include "io/format.h"
#include "model/project.h"

namespace inkflate {

/// What a file holds that can be drawn or inflated, whatever its format.
struct ReadDocument {
  FileFormat format = FileFormat::Unknown;
  Project project;  // with layers where the file has them; nothing drawn where there is a scan
  std::optional<Picture> scan;             // a picture whose strokes are still to be found
  std::vector<std::string> warnings = {};  // what of the file was left out
};

/// Reads strokes (SVG, .scap), a scan (PNG, JPEG) or a project (SVG by write_svg, .inkflate, Monster Mash, the
/// last document of a journal), by what the bytes are, not by a name.
///
/// errors  those of the readers; Unsupported (another format)
Result<ReadDocument> read_document(std::span<std::byte const> content);

/// Whether there are contours already, so that nothing has to be simplified.
bool has_layers(ReadDocument const& document);

}  // namespace inkflate
