// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/rest_model.h"

namespace inkflate {

/// A model as binary glTF 2.0: one node, one mesh, one primitive, one material, which every reader understands.
///
/// in      model: finite, at least one triangle
///         texture: for this model; null: a material like warm clay
///         name: of the node and the mesh
/// out     y up; 100 px are one unit. The texture is inside as PNG. The mesh's extras name the layers and the stretch of
///         triangles of each. Same model, same bytes
/// cost    O(n), and the packing of the picture
/// source  glTF 2.0 specification (Khronos, 2021), sections 3.6, 3.7, 3.9 and 4.4
std::vector<std::byte> write_glb(RestModel const& model, Texture const* texture = nullptr,
                                 std::string const& name = "character");

}  // namespace inkflate
