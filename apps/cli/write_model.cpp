// SPDX-License-Identifier: Apache-2.0
#include "cli/write_model.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "cli/files.h"
#include "cli/output_plan.h"
#include "io/print_pose.h"
#include "io/write_3mf.h"
#include "io/write_glb.h"
#include "io/write_obj.h"
#include "io/write_stl.h"
#include "render/palette.h"

namespace inkflate::cli {
namespace {

std::string name_of(std::string const& path) {
  return path == kStandardStream ? "character" : std::filesystem::path(path).stem().string();
}

/// One after the other, so that what a file names is there before it.
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

std::vector<PrintColour> colours_of(Drawing const& drawing) {
  std::vector<PrintColour> colours;
  for (auto const& layer : drawing.layers) {
    colours.push_back({layer.name, layer.fill.value_or(palette::kSkin)});
  }
  return colours;
}

std::vector<std::byte> coloured_3mf(RestModel const& model, Drawing const& drawing,
                                    std::string const& name) {
  PrintObject object = {name, print_pose(model.mesh), {}};
  for (auto const& face : model.faces) object.colours.push_back(face.layer);
  std::vector<PrintObject> const objects = {std::move(object)};
  return write_3mf(objects, colours_of(drawing), name);
}

}  // namespace

std::optional<ModelFormat> model_format(std::string const& path) {
  if (path == kStandardStream) return ModelFormat::Glb;
  auto const extension = lower_extension(path);
  if (extension == ".glb") return ModelFormat::Glb;
  if (extension == ".obj") return ModelFormat::Obj;
  if (extension == ".stl") return ModelFormat::Stl;
  if (extension == ".3mf") return ModelFormat::ThreeMf;
  return std::nullopt;
}

std::optional<Error> write_model(RestModel const& model, Texture const* texture,
                                 Drawing const& drawing, ModelFormat format,
                                 std::string const& path) {
  switch (format) {
    case ModelFormat::Glb:
      return write_file(path, write_glb(model, texture, name_of(path)));
    case ModelFormat::Obj:
      return write_obj_files(write_obj(model, texture, name_of(path)), path);
    case ModelFormat::Stl:
      return write_file(path, write_stl(print_pose(model.mesh)));
    case ModelFormat::ThreeMf:
      return write_file(path, coloured_3mf(model, drawing, name_of(path)));
  }
  CHECK(false, "every format has its writer");
}

std::optional<Error> write_print(TriMesh const& shell, Drawing const& drawing, ModelFormat format,
                                 std::string const& path) {
  if (format == ModelFormat::Stl) return write_file(path, write_stl(shell));
  CHECK(format == ModelFormat::ThreeMf, "only STL and 3MF are printed");
  // The layers are one piece now: it gets the colour of the first one.
  std::vector<int> const colours(shell.triangles.size(), 0);
  std::vector<PrintObject> const objects = {{name_of(path), shell, colours}};
  return write_file(path, write_3mf(objects, colours_of(drawing), name_of(path)));
}

}  // namespace inkflate::cli
