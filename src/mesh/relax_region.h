// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/region_triangulation.h"

namespace inkflate {

/// Puts a vertex on every edge inside that joins two points of the rim, and into a triangle that is the whole region. From then on none
/// comes back.
///
/// out     false: a triangle is so thin that doubles hold no point inside it
bool part_rim(RegionTriangulation& region);

/// Moves the vertices inside to the middle of their neighbours, and turns edges, so that triangles come closer to equal sides.
/// cost    O(n) per pass
void relax_region(RegionTriangulation& region, int passes);

}  // namespace inkflate
