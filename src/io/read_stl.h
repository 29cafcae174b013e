// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/read_mesh.h"

namespace inkflate {

/// STL, binary if it is exactly as long as its number of triangles says, else text. What it holds is described in read_mesh.h.
Result<MeshReading> read_stl(std::span<std::byte const> file);

}  // namespace inkflate
