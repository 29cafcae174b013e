// SPDX-License-Identifier: Apache-2.0
#include "cli/drawing_outputs.h"

#include <cstddef>
#include <utility>

#include "cli/files.h"
#include "cli/output_plan.h"

namespace inkflate::cli {
namespace {

std::optional<Error> check_streams(SharedOptions const& shared, std::string const& picture) {
  if (shared.output.empty() && picture.empty() && !shared.is_json) {
    return Error{ErrorCode::BadOption, "nothing to make: give -o OUTPUT, --picture FILE or --json"};
  }
  if (picture == kStandardStream) {
    return Error{ErrorCode::BadOption, "--picture needs a file name"};
  }
  if (shared.is_json && shared.output == kStandardStream) {
    return Error{ErrorCode::BadOption, "-o - and --json both want standard output; name a file"};
  }
  return std::nullopt;
}

}  // namespace

Result<DrawingOutputs> plan_drawing_outputs(SharedOptions const& shared, std::string const& picture,
                                            std::string const& extension,
                                            std::vector<std::string> const& read) {
  if (auto error = check_streams(shared, picture)) return *std::move(error);
  auto paths =
      plan_files_and_pictures(shared.inputs, {"-o", shared.output, extension}, picture, read);
  if (!paths) return paths.error();
  DrawingOutputs outputs = {std::move(paths->files), {}, std::move(paths->pictures)};
  for (auto const& file : outputs.files) {
    auto const format = file.empty() ? DrawingFormat::Svg : drawing_format(file);
    if (!format) return format.error();
    outputs.formats.push_back(*format);
  }
  return outputs;
}

std::optional<Error> write_drawing_outputs(Project const& project, DrawingOutputs const& outputs,
                                           int index) {
  auto const place = static_cast<std::size_t>(index);
  if (auto const& file = outputs.files[place]; !file.empty()) {
    if (auto error = write_drawing(project, outputs.formats[place], file)) return error;
  }
  auto const& picture = outputs.pictures[place];
  return picture.empty() ? std::nullopt : save_drawing_picture(project.drawing, picture);
}

}  // namespace inkflate::cli
