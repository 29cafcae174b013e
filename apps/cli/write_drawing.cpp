// SPDX-License-Identifier: Apache-2.0
#include "cli/write_drawing.h"

#include <algorithm>
#include <cmath>

#include "cli/files.h"
#include "cli/output_plan.h"
#include "io/read_picture.h"
#include "io/write_inkflate.h"
#include "io/write_monster_mash.h"
#include "io/write_png.h"
#include "io/write_svg.h"
#include "render/draw_drawing.h"
#include "render/draw_mask.h"
#include "render/palette.h"
#include "render/rasterise.h"

namespace inkflate::cli {
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

Result<DrawingFormat> drawing_format(std::string const& path) {
  if (path == kStandardStream) return DrawingFormat::Svg;
  auto const extension = lower_extension(path);
  if (extension == ".svg") return DrawingFormat::Svg;
  if (extension == ".png") return DrawingFormat::Mask;
  if (extension == ".inkflate") return DrawingFormat::Inkflate;
  if (extension == ".zip") return DrawingFormat::MonsterMash;
  return Error{ErrorCode::BadOption,
               "cannot write " + path + ": drawings are written as .svg, .inkflate, .zip and .png"};
}

std::optional<Error> write_drawing(Project const& project, DrawingFormat format,
                                   std::string const& path) {
  switch (format) {
    case DrawingFormat::Svg:
      return write_file(path, write_svg(project.drawing));
    case DrawingFormat::Inkflate: {
      auto const content = write_inkflate(project);
      return content ? save_file(path, *content) : content.error();
    }
    case DrawingFormat::MonsterMash: {
      auto const content = write_monster_mash(project);
      return content ? write_file(path, *content) : content.error();
    }
    case DrawingFormat::Mask:
      break;
  }
  if (auto error = check_picture_size(project.drawing.sketch)) return error;
  return write_file(path, write_png(draw_mask(project.drawing)));
}

std::optional<Error> write_drawing_picture(Drawing const& drawing, std::string const& path) {
  if (auto error = check_picture_size(drawing.sketch)) return error;
  DrawDrawingOptions const options = {.rough_strokes = RoughStrokes::Faint};
  auto const list =
      drawing.layers.empty() ? draw_sketch(drawing.sketch) : draw_drawing(drawing, options);
  auto const picture =
      rasterise(list, static_cast<int>(std::ceil(drawing.sketch.width_px)),
                static_cast<int>(std::ceil(drawing.sketch.height_px)), palette::kPaper);
  return write_file(path, write_png(picture));
}

}  // namespace inkflate::cli
