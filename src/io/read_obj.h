// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "io/read_mesh.h"

namespace inkflate {

/// Wavefront OBJ: its vertices and faces; what that holds is described in read_mesh.h. Faces of more than three corners are cut into
/// a fan; curves and surfaces are passed over.

bool is_obj(std::string_view text);
Result<MeshReading> read_obj(std::string_view text);

}  // namespace inkflate
