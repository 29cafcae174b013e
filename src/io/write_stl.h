// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// A mesh as binary STL, coordinates as they are: STL knows no unit, and every slicer takes it for millimetres.
///
/// in      mesh: finite, at most 2^32 - 1 triangles; as it stands on the printer (io/print_pose.h)
/// out     same mesh, same bytes. Normals follow the corners as stored; those of triangles without area are zero
std::vector<std::byte> write_stl(TriMesh const& mesh);

}  // namespace inkflate
