// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/drawing.h"
#include "model/rest_model.h"

namespace inkflate {

/// What a model can be written as.
enum class ModelFormat {
  Glb,
  Obj,  // with NAME.mtl and NAME.png beside it
  Stl,
  ThreeMf,
};

/// By an extension with its dot, in lower case: ".glb". Nothing: none of these.
std::optional<ModelFormat> model_format_of(std::string_view extension);

struct ModelFile {
  std::string extension;  // ".obj"
  std::vector<std::byte> bytes;
};

/// The model as it is. STL and 3MF are 100 mm along their longest side and stand upright.
///
/// in      texture: for GLB and OBJ; null: a plain material
///         drawing: its layers' colours are those of a 3MF
///         name: of the files without extension
/// out     what a file names comes before it; the last is the model
std::vector<ModelFile> write_model_files(RestModel const& model, Texture const* texture,
                                         Drawing const& drawing, ModelFormat format,
                                         std::string const& name);

/// A single shell to print, in mm, as STL or 3MF; it has the colour of the drawing's first layer.
std::vector<std::byte> write_print_file(TriMesh const& shell, Drawing const& drawing,
                                        ModelFormat format, std::string const& name);

}  // namespace inkflate
