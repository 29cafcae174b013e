// SPDX-License-Identifier: Apache-2.0
#include "cli/write_drawing.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/files.h"
#include "io/write_png.h"
#include "io/write_svg.h"
#include "render/draw_drawing.h"
#include "render/draw_mask.h"
#include "render/palette.h"
#include "render/rasterise.h"

namespace inkflate::cli {
namespace {

// docs/LIMITS.md: what we do not read we do not write either.
constexpr double kMaxSidePx = 16384;
constexpr double kMaxPixels = 64e6;

std::optional<Error> check_picture_size(Sketch const& canvas) {
  double const width = std::ceil(canvas.width_px);
  double const height = std::ceil(canvas.height_px);
  if (width <= kMaxSidePx && height <= kMaxSidePx && width * height <= kMaxPixels) return {};
  return Error{ErrorCode::TooLarge,
               "a picture of this canvas would be over 16384 px or 64 megapixels; try --size 2048"};
}

std::optional<Error> write_bytes(Result<std::vector<std::byte>> const& content,
                                 std::string const& path) {
  if (!content) return content.error();
  return write_file(path, *content);
}

}  // namespace

Result<DrawingFormat> drawing_format(std::string const& path) {
  if (path == kStandardStream) return DrawingFormat::Svg;
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  if (extension == ".svg") return DrawingFormat::Svg;
  if (extension == ".png") return DrawingFormat::Mask;
  return Error{ErrorCode::BadOption, "cannot write " + path + ": simplify writes .svg and .png"};
}

std::optional<Error> write_drawing(Drawing const& drawing, DrawingFormat format,
                                   std::string const& path) {
  if (format == DrawingFormat::Svg) return write_file(path, write_svg(drawing));
  if (auto const error = check_picture_size(drawing.sketch)) return error;
  return write_bytes(write_png(draw_mask(drawing)), path);
}

std::optional<Error> write_drawing_picture(Drawing const& drawing, std::string const& path) {
  if (auto const error = check_picture_size(drawing.sketch)) return error;
  DrawDrawingOptions const options = {.rough_strokes = RoughStrokes::Faint};
  auto const picture = rasterise(draw_drawing(drawing, options),
                                 static_cast<int>(std::ceil(drawing.sketch.width_px)),
                                 static_cast<int>(std::ceil(drawing.sketch.height_px)),
                                 palette::kPaper);
  return write_bytes(write_png(picture), path);
}

}  // namespace inkflate::cli
