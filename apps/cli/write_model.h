// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "model/project.h"
#include "model/rest_model.h"

namespace inkflate::cli {

/// What a model can be written as.
enum class ModelFormat {
  Glb,  // standard output gets this
  Obj,  // with NAME.mtl and NAME.png beside it
  Stl,
  ThreeMf,
};

/// By the extension of the output's name, in any case; nothing: none of these.
std::optional<ModelFormat> model_format(std::string const& path);

/// The model as it is, put in place as a whole. STL and 3MF are 100 mm along their longest side and stand upright.
///
/// in      texture: for GLB and OBJ; none: a plain material
///         drawing: its layers' colours are those of a 3MF
/// errors  FileSystem
std::optional<Error> write_model(RestModel const& model, Texture const* texture,
                                 Drawing const& drawing, ModelFormat format,
                                 std::string const& path);

/// A single shell to print, in mm, as STL or 3MF, put in place as a whole.
///
/// errors  FileSystem
std::optional<Error> write_print(TriMesh const& shell, Drawing const& drawing, ModelFormat format,
                                 std::string const& path);

}  // namespace inkflate::cli
