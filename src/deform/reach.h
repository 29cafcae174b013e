// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/bend_mesh.h"

namespace inkflate {

/// How far each vertex of a mesh is from a place of it, by the shortest way inside the mesh, px. Infinite where there is none.
///
/// Ways go straight as far as triangles let them and around the mesh's corners; beyond several corners they may be a little too long.
/// cost    O(n log n)
/// source  Mitchell, Mount, Papadimitriou 1987, "The Discrete Geodesic Problem", with one source per vertex; docs/algorithms/ride.md
std::vector<double> ways_inside(FlatMesh const& mesh, BendAnchor const& from);

/// How much stiffer each triangle is towards the end of a reach: there the shape would bend most, next to what stays, and have a kink.
///
/// in      ways_px: of each vertex, as ways_inside gives them; reach_px > 0
/// out     1 near the hand, more from half of the reach on; all that is beyond is as stiff as its end
std::vector<double> stiffening_within(FlatMesh const& mesh, std::span<double const> ways_px,
                                      double reach_px);

/// How much each vertex is held where it is towards the end of a reach, as BendHold::tethers has it: in proportion to the mesh it stands for.
///
/// in      ways_px: of each vertex, as ways_inside gives them; reach_px > 0
/// out     0 up to half of the reach, growing without a step to its end; 0 for all that is beyond
std::vector<double> tethers_within(BendMesh const& mesh, std::span<double const> ways_px,
                                   double reach_px);

}  // namespace inkflate
