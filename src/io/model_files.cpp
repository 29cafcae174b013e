// SPDX-License-Identifier: Apache-2.0
#include "io/model_files.h"

#include <utility>

#include "base/check.h"
#include "io/print_pose.h"
#include "io/put_bytes.h"
#include "io/write_3mf.h"
#include "io/write_glb.h"
#include "io/write_obj.h"
#include "io/write_stl.h"
#include "render/palette.h"

namespace inkflate {
namespace {

std::vector<ModelFile> obj_files(ObjFiles files) {
  std::vector<ModelFile> result;
  if (!files.png.empty()) result.push_back({".png", std::move(files.png)});
  result.push_back({".mtl", bytes_of(files.mtl)});
  result.push_back({".obj", bytes_of(files.obj)});
  return result;
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

std::optional<ModelFormat> model_format_of(std::string_view extension) {
  if (extension == ".glb") return ModelFormat::Glb;
  if (extension == ".obj") return ModelFormat::Obj;
  if (extension == ".stl") return ModelFormat::Stl;
  if (extension == ".3mf") return ModelFormat::ThreeMf;
  return std::nullopt;
}

std::vector<ModelFile> write_model_files(RestModel const& model, Texture const* texture,
                                         Drawing const& drawing, ModelFormat format,
                                         std::string const& name) {
  switch (format) {
    case ModelFormat::Glb:
      return {{".glb", write_glb(model, texture, name)}};
    case ModelFormat::Obj:
      return obj_files(write_obj(model, texture, name));
    case ModelFormat::Stl:
      return {{".stl", write_stl(print_pose(model.mesh))}};
    case ModelFormat::ThreeMf:
      return {{".3mf", coloured_3mf(model, drawing, name)}};
  }
  CHECK(false, "every format has its writer");
}

std::vector<std::byte> write_print_file(TriMesh const& shell, Drawing const& drawing,
                                        ModelFormat format, std::string const& name) {
  if (format == ModelFormat::Stl) return write_stl(shell);
  CHECK(format == ModelFormat::ThreeMf, "only STL and 3MF are printed");
  // The layers are one piece now: it gets the colour of the first one.
  std::vector<int> const colours(shell.triangles.size(), 0);
  std::vector<PrintObject> const objects = {{name, shell, colours}};
  return write_3mf(objects, colours_of(drawing), name);
}

}  // namespace inkflate
