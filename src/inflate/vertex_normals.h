// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// A normal of length 1 for each vertex: the mean of those of its triangles, weighted by area, and smoothed over the vertices around it. (0, 0, 1)
/// for a vertex without area.
std::vector<Vec3> vertex_normals(TriMesh const& mesh);

}  // namespace inkflate
