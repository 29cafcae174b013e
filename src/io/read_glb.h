// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/read_mesh.h"

namespace inkflate {

/// Binary glTF 2.0: the triangles of every mesh that a node shows; what that holds is described in read_mesh.h. Unsupported: data
/// outside of the file, sparse or packed accessors, strips and fans, nodes that move their mesh.
Result<MeshReading> read_glb(std::span<std::byte const> file);

}  // namespace inkflate
