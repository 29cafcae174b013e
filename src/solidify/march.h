// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/tri_mesh.h"
#include "solidify/snap_nodes.h"

namespace inkflate {

/// The surface between inside and outside, from the lattice's tetrahedra.
///
/// out     closed, 2-manifold, oriented, without self-crossings; lattice units
/// cost    O(nodes)
/// source  marching tetrahedra on the body-centred lattice, with nodes on the surface as in Labelle and Shewchuk 2007
TriMesh march(Solid const& solid, Cuts const& cuts, SnappedNodes const& snapped);

}  // namespace inkflate
