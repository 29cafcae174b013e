// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// For each vertex the lowest one that edges of triangles connect it with: itself where it is in none. Vertices of one connected piece
/// have the same.
///
/// cost    O(vertices + triangles), about
std::vector<int> connected_vertices(FlatMesh const& mesh);

}  // namespace inkflate
