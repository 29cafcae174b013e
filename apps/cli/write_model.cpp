// SPDX-License-Identifier: Apache-2.0
#include "cli/write_model.h"

#include <filesystem>
#include <vector>

#include "cli/files.h"
#include "cli/output_plan.h"

namespace inkflate::cli {
namespace {

std::string name_of(std::string const& path) {
  return path == kStandardStream ? "character" : std::filesystem::path(path).stem().string();
}

}  // namespace

std::optional<ModelFormat> model_format(std::string const& path) {
  if (path == kStandardStream) return ModelFormat::Glb;
  return model_format_of(lower_extension(path));
}

std::optional<Error> write_model(RestModel const& model, Texture const* texture,
                                 Drawing const& drawing, ModelFormat format,
                                 std::string const& path) {
  auto const files = write_model_files(model, texture, drawing, format, name_of(path));
  for (auto const& file : files) {
    bool const is_model = &file == &files.back();
    auto const beside = std::filesystem::path(path).replace_extension(file.extension).string();
    if (auto error = write_file(is_model ? path : beside, file.bytes)) return error;
  }
  return std::nullopt;
}

std::optional<Error> write_print(TriMesh const& shell, Drawing const& drawing, ModelFormat format,
                                 std::string const& path) {
  return write_file(path, write_print_file(shell, drawing, format, name_of(path)));
}

}  // namespace inkflate::cli
