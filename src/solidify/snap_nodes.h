// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solidify/cuts.h"
#include "solidify/solid.h"

namespace inkflate {

/// Nodes that were moved onto the surface.
struct SnappedNodes {
  KeyTable nodes;
  std::vector<Vec3> places;
  std::vector<bool> is_of_ball;  // the surface that a node was moved to
};

/// Moves nodes that are very close to the surface onto it, so that no small triangles arise there; but only where the surface stays a
/// surface. Their side becomes On.
///
/// cost    O(n log n) in the cuts
/// source  Labelle and Shewchuk 2007, "Isosurface stuffing", section 3.2, for the moves; docs/algorithms/solidify.md for the check
SnappedNodes snap_nodes(Solid& solid, Cuts const& cuts);

}  // namespace inkflate
