// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/edge_grid.h"

namespace inkflate {

/// How far from the origin points of a lattice may lie: products of their differences are exact in double.
inline constexpr double kLatticeReach = 16'777'216;  // 2^24

/// An edge between two different points with whole coordinates.
struct LatticeEdge {
  Edge edge;
  int tag = 0;  // pieces keep it
};

/// Cuts edges wherever they meet, so that at the end no two of them have a point in common but ends of both, or are the same. A place
/// where edges cross moves to the next whole point, and the edges with it, by less than 1.
///
/// in      edges: within kLatticeReach
/// out     false: they could not be cut so; edges is then of no use
/// cost    O(n + pieces) for edges of similar length, times a few rounds
/// source  iterated snap rounding: Guibas and Marimont 1998; Halperin and Packer 2002
bool cut_where_they_meet(std::vector<LatticeEdge>& edges);

}  // namespace inkflate
