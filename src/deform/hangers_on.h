// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// What stays goes along where it is small and hangs on what moves: the ear of a head that is bent down. Without it such an end would be
/// torn out long between the two.
///
/// in      stays: per vertex; way_px: of each from the hand, infinite where there is none
/// out     stays is taken from pieces that hang together and are smaller than a tenth of what moves
/// cost    O(n)
/// source  docs/algorithms/ride.md
void free_hangers_on(FlatMesh const& mesh, std::vector<double> const& way_px,
                     std::vector<char>& stays);

}  // namespace inkflate
