// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "io/model_files.h"

namespace inkflate::cli {

/// By the extension of the output's name, in any case; standard output gets GLB; nothing: none of these.
std::optional<ModelFormat> model_format(std::string const& path);

/// The model as it is, with what belongs to it beside it, each file put in place as a whole.
///
/// in      as write_model_files
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
