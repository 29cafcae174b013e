// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "io/drawing_file.h"

namespace inkflate::cli {

/// By the extension of the output's name, in any case; standard output gets SVG. BadOption: one that we do not write.
Result<DrawingFormat> drawing_format(std::string const& path);

/// The project in this format, put in place as a whole; of an .inkflate the last version is kept.
///
/// errors  FileSystem; those of write_drawing_file
std::optional<Error> write_drawing(Project const& project, DrawingFormat format,
                                   std::string const& path);

/// A picture of the drawing to look at, as PNG.
///
/// errors  as write_drawing
std::optional<Error> save_drawing_picture(Drawing const& drawing, std::string const& path);

}  // namespace inkflate::cli
