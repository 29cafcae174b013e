// SPDX-License-Identifier: Apache-2.0
#include "cli/write_model.h"

#include <filesystem>

#include "cli/files.h"
#include "cli/output_plan.h"
#include "io/print_pose.h"
#include "io/write_glb.h"
#include "io/write_obj.h"
#include "io/write_stl.h"

namespace inkflate::cli {
namespace {

std::string name_of(std::string const& path) {
  return path == kStandardStream ? "character" : std::filesystem::path(path).stem().string();
}

/// The three files one after the other: what the first names is there before it.
std::optional<Error> write_obj_files(ObjFiles const& files, std::string const& path) {
  auto const beside = [&](char const* extension) {
    return std::filesystem::path(path).replace_extension(extension).string();
  };
  if (!files.png.empty()) {
    if (auto error = write_file(beside(".png"), files.png)) return error;
  }
  if (auto error = write_file(beside(".mtl"), files.mtl)) return error;
  return write_file(path, files.obj);
}

}  // namespace

std::optional<ModelFormat> model_format(std::string const& path) {
  if (path == kStandardStream) return ModelFormat::Glb;
  auto const extension = lower_extension(path);
  if (extension == ".glb") return ModelFormat::Glb;
  if (extension == ".obj") return ModelFormat::Obj;
  if (extension == ".stl") return ModelFormat::Stl;
  return std::nullopt;
}

std::optional<Error> write_model(RestModel const& model, Texture const* texture, ModelFormat format,
                                 std::string const& path) {
  switch (format) {
    case ModelFormat::Glb:
      return write_file(path, write_glb(model, texture, name_of(path)));
    case ModelFormat::Obj:
      return write_obj_files(write_obj(model, texture, name_of(path)), path);
    case ModelFormat::Stl:
      return write_file(path, write_stl(print_pose(model.mesh)));
  }
  CHECK(false, "every format has its writer");
}

}  // namespace inkflate::cli
