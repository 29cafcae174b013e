// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "solidify/lattice.h"
#include "solidify/solid.h"

namespace inkflate {

/// The sides of a node's fourteen neighbours. They are the corners of a sphere of 24 triangles around it, its link.
using LinkSides = std::array<NodeSide, kDirections>;

/// The neighbours that a node and its neighbour in direction d have in common, in order around the step between them: 4 or 6.
std::span<int const> ring_around(int d);

/// Whether the surface near a node that lies on it is one disc: in the link, one closed line parts inside from outside. Some links for
/// which it is are refused all the same.
bool is_disc(LinkSides const& link);

}  // namespace inkflate
