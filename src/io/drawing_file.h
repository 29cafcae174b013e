// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "model/project.h"

namespace inkflate {

/// What a drawing can be written as.
enum class DrawingFormat {
  Svg,          // contours and strokes
  Inkflate,     // all of the project
  MonsterMash,  // needs layers
  MaskPicture,  // PNG: 255 inside, 0 outside
};

/// By an extension with its dot, in lower case: ".svg". Nothing: none of these.
std::optional<DrawingFormat> drawing_format_of(std::string_view extension);

/// The project in this format; SVG and mask hold the drawing alone.
///
/// errors  TooLarge (the file would pass the limits); NothingThere (no layers, or no canvas)
Result<std::vector<std::byte>> write_drawing_file(Project const& project, DrawingFormat format);

/// A picture of the drawing to look at, as PNG: filled shapes, outlines, the rough strokes faintly; without layers the strokes.
///
/// errors  as write_drawing_file
Result<std::vector<std::byte>> write_drawing_picture(Drawing const& drawing);

}  // namespace inkflate
