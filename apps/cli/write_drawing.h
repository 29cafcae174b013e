// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "model/project.h"

namespace inkflate::cli {

/// What a drawing can be written as.
enum class DrawingFormat {
  Svg,          // contours and strokes; standard output gets this
  Inkflate,     // all of the project; the last version of the file is kept
  MonsterMash,  // needs layers
  Mask,         // PNG: 255 inside, 0 outside
};

/// By the extension of the output's name, in any case. BadOption: one that we do not write.
Result<DrawingFormat> drawing_format(std::string const& path);

/// The project in this format, put in place as a whole. SVG and mask hold the drawing alone.
///
/// errors  FileSystem; TooLarge (the file would pass the limits); NothingThere (no layers, or no canvas)
std::optional<Error> write_drawing(Project const& project, DrawingFormat format,
                                   std::string const& path);

/// A picture of the drawing to look at, as PNG: filled shapes, outlines, the rough strokes faintly; without layers the strokes.
///
/// errors  as write_drawing
std::optional<Error> write_drawing_picture(Drawing const& drawing, std::string const& path);

}  // namespace inkflate::cli
