// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// The area that belongs to each point of a mesh: a third of each of its triangles. 0 for points without triangles.
std::vector<double> point_areas(FlatMesh const& mesh);

}  // namespace inkflate
