// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deform/bend_mesh.h"

namespace inkflate {

/// An edge of a mesh between vertices a < b.
struct WireEdge {
  int a = 0;
  int b = 0;
  double weight = 0;  // > 0: its cotangent weight, with the stiffness of the triangles at it
  Vec2 rest;          // a - b, px
};

/// The edges of a mesh with cotangent weights, sorted by their vertices.
///
/// An angle below 0.6 degrees counts as 0.6 degrees, so that triangles without area have weights too. Weights that come out negative,
/// opposite to obtuse angles, or zero, across a rectangle, are set to a hundredth of that of a right-angled triangle: the matrix
/// of the weights stays definite and the energy a sum of squares.
///
/// cost    O(n log n)
/// source  thesis, eq. 4.3
std::vector<WireEdge> wire_edges(BendMesh const& mesh);

}  // namespace inkflate
