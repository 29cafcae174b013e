// SPDX-License-Identifier: Apache-2.0
#include "io/drawing_file.h"

#include <algorithm>
#include <cmath>

#include "io/put_bytes.h"
#include "io/read_picture.h"
#include "io/write_inkflate.h"
#include "io/write_monster_mash.h"
#include "io/write_png.h"
#include "io/write_svg.h"
#include "render/draw_drawing.h"
#include "render/draw_mask.h"
#include "render/palette.h"
#include "render/rasterise.h"

namespace inkflate {
namespace {

// What we do not read we do not write either.
std::optional<Error> check_picture_size(Sketch const& canvas) {
  double const width_px = std::ceil(canvas.width_px);
  double const height_px = std::ceil(canvas.height_px);
  if (!(width_px >= 1 && height_px >= 1)) {
    return Error{ErrorCode::NothingThere, "the canvas has no size; try --size 1024 --fit"};
  }
  if (std::max(width_px, height_px) <= PictureLimits::kSidePx &&
      width_px * height_px <= PictureLimits::kPixels) {
    return std::nullopt;
  }
  return Error{ErrorCode::TooLarge,
               "a picture of this canvas would be over 16384 px or 64 megapixels; try --size 2048"};
}

}  // namespace

std::optional<DrawingFormat> drawing_format_of(std::string_view extension) {
  if (extension == ".svg") return DrawingFormat::Svg;
  if (extension == ".png") return DrawingFormat::MaskPicture;
  if (extension == ".inkflate") return DrawingFormat::Inkflate;
  if (extension == ".zip") return DrawingFormat::MonsterMash;
  return std::nullopt;
}

Result<std::vector<std::byte>> write_drawing_file(Project const& project, DrawingFormat format) {
  switch (format) {
    case DrawingFormat::Svg:
      return bytes_of(write_svg(project.drawing));
    case DrawingFormat::Inkflate:
      return write_inkflate(project);
    case DrawingFormat::MonsterMash:
      return write_monster_mash(project);
    case DrawingFormat::MaskPicture:
      break;
  }
  if (auto error = check_picture_size(project.drawing.sketch)) return *error;
  return write_png(draw_mask(project.drawing));
}

Result<std::vector<std::byte>> write_drawing_picture(Drawing const& drawing) {
  if (auto error = check_picture_size(drawing.sketch)) return *error;
  DrawDrawingOptions const options = {.rough_strokes = RoughStrokes::Faint};
  auto const list =
      drawing.layers.empty() ? draw_sketch(drawing.sketch) : draw_drawing(drawing, options);
  return write_png(rasterise(list, static_cast<int>(std::ceil(drawing.sketch.width_px)),
                             static_cast<int>(std::ceil(drawing.sketch.height_px)),
                             palette::kPaper));
}

}  // namespace inkflate
