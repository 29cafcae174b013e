// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deform/bend_mesh.h"

namespace inkflate {

/// How far each vertex of a mesh is from a place of it, by the shortest way inside the mesh, px. Infinite where there is none.
///
/// Ways go straight as far as triangles let them and around the mesh's corners; beyond several corners they may be a little too long.
/// cost    O(n log n)
/// source  Mitchell, Mount, Papadimitriou 1987, "The Discrete Geodesic Problem", with one source per vertex; docs/algorithms/ride.md
std::vector<double> ways_inside(FlatMesh const& mesh, BendAnchor const& from);

}  // namespace inkflate
