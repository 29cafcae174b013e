// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "io/read_mesh.h"

namespace inkflate {

/// Wavefront OBJ: its vertices and faces; what that holds is described in read_mesh.h. Faces of more than three corners are cut into
/// a fan; curves and surfaces are passed over.
Result<MeshReading> read_obj(std::span<std::byte const> file);

}  // namespace inkflate
