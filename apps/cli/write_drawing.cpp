// SPDX-License-Identifier: Apache-2.0
#include "cli/write_drawing.h"

#include "cli/files.h"
#include "cli/output_plan.h"

namespace inkflate::cli {

Result<DrawingFormat> drawing_format(std::string const& path) {
  if (path == kStandardStream) return DrawingFormat::Svg;
  auto const format = drawing_format_of(lower_extension(path));
  if (format) return *format;
  return Error{ErrorCode::BadOption,
               "cannot write " + path + ": drawings are written as .svg, .inkflate, .zip and .png"};
}

std::optional<Error> write_drawing(Project const& project, DrawingFormat format,
                                   std::string const& path) {
  auto const content = write_drawing_file(project, format);
  if (!content) return content.error();
  return format == DrawingFormat::Inkflate ? save_file(path, *content) : write_file(path, *content);
}

std::optional<Error> save_drawing_picture(Drawing const& drawing, std::string const& path) {
  auto const content = write_drawing_picture(drawing);
  return content ? write_file(path, *content) : content.error();
}

}  // namespace inkflate::cli
