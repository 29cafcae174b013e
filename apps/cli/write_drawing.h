// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "model/drawing.h"

namespace inkflate::cli {

/// What a simplified drawing can be written as.
enum class DrawingFormat {
  Svg,   // contours and strokes; standard output gets this
  Mask,  // PNG: 255 inside, 0 outside
};

/// By the extension of the output's name, in any case. BadOption: one that we do not write.
Result<DrawingFormat> drawing_format(std::string const& path);

/// The drawing as its silhouette or as SVG, put in place as a whole.
///
/// errors  FileSystem; TooLarge (a picture of this canvas would pass the limits)
std::optional<Error> write_drawing(Drawing const& drawing, DrawingFormat format,
                                   std::string const& path);

/// A picture of the drawing to look at: filled shapes, outlines, the rough strokes faintly. A PNG file.
///
/// errors  as write_drawing
std::optional<Error> write_drawing_picture(Drawing const& drawing, std::string const& path);

}  // namespace inkflate::cli
