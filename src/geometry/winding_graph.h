// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/lattice_edges.h"

namespace inkflate {

/// A boundary of the area around which edges wind, as a closed chain of whole points.
struct BoundaryChain {
  std::vector<Vec2> points;
  std::vector<int> tags;  // of the edge that leaves each point
  /// Per point: others pass here, and outside is the smaller side of the corner.
  std::vector<char> is_to_bridge;
};

/// The boundaries of the area around which edges wind at all, the area on their left (positive side). Where several meet in a point, each
/// turns there so that the outside stays apart and the area together.
///
/// in      edges: of closed walks, with no point in common but ends (cut_where_they_meet)
/// cost    O(n log n), and O(n) for each connected piece
std::vector<BoundaryChain> boundary_chains(std::span<LatticeEdge const> edges);

}  // namespace inkflate
