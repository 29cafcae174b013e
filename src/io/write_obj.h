// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/rest_model.h"

namespace inkflate {

/// The files that stand side by side: NAME.obj, NAME.mtl and NAME.png.
struct ObjFiles {
  std::string obj;
  std::string mtl;
  std::vector<std::byte> png;  // empty without a texture
};

/// A model as Wavefront OBJ with normals, one object per layer. Layers share vertices where they are joined.
///
/// in      model: finite
///         texture: for this model; null: a material like warm clay
///         name: of the files without their extensions; they name each other by it
/// out     y up; 100 px are one unit, rounded to a millionth of it. Same model, same bytes
ObjFiles write_obj(RestModel const& model, Texture const* texture, std::string const& name);

}  // namespace inkflate
