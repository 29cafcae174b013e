// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/read_mesh.h"

namespace inkflate {

/// 3MF: the triangles of what is to be printed, in the file's unit; what that holds is described in read_mesh.h. Unsupported: components
/// of components.
Result<MeshReading> read_3mf(std::span<std::byte const> file);

}  // namespace inkflate
