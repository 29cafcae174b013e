// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/tri_mesh.h"
#include "solidify/snap_nodes.h"

namespace inkflate {

/// Where a vertex may be so that no two triangles cross: a cut anywhere on its step, a snapped node anywhere near its node.
struct Anchor {
  Vec3 node;
  Vec3 step;  // zero: the vertex is a snapped node
  bool is_of_ball = false;
};

struct MarchedMesh {
  TriMesh mesh;                 // lattice units
  std::vector<Anchor> anchors;  // per vertex
};

/// The place that a vertex may have which is nearest to a wanted one, or nearly so.
Vec3 nearest_allowed(Anchor const& anchor, Vec3 wanted);

/// The surface between inside and outside, from the lattice's tetrahedra.
///
/// out     closed, 2-manifold, oriented, without self-crossings
/// cost    O(nodes)
/// source  marching tetrahedra on the body-centred lattice, with nodes on the surface as in Labelle and Shewchuk 2007
MarchedMesh march(Solid const& solid, Cuts const& cuts, SnappedNodes const& snapped);

}  // namespace inkflate
