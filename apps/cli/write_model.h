// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "model/rest_model.h"

namespace inkflate::cli {

/// What a model can be written as.
enum class ModelFormat {
  Glb,  // standard output gets this
  Obj,  // with NAME.mtl and NAME.png beside it
  Stl,
};

/// By the extension of the output's name, in any case; nothing: none of these.
std::optional<ModelFormat> model_format(std::string const& path);

/// The model, put in place as a whole.
///
/// in      texture: none: a plain material
/// errors  FileSystem
std::optional<Error> write_model(RestModel const& model, Texture const* texture, ModelFormat format,
                                 std::string const& path);

}  // namespace inkflate::cli
