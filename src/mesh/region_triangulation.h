// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "mesh/dynamic_triangulation.h"
#include "mesh/mesh_region.h"

namespace inkflate {

/// A region cut into triangles between the points of its rim and its seams, and which triangles lie in it.
struct RegionTriangulation {
  DynamicTriangulation triangles;
  std::vector<std::uint8_t> is_inside;  // per triangle
};

/// The constrained Delaunay triangulation of a region's own points: vertices are the contours' points in order, then the seams'.
///
/// errors  BadInput, as mesh_region
/// cost    O(n log n) expected, about 0.6 us per point
/// source  Sloan 1993 (edges that are missing); Lawson 1977
Result<RegionTriangulation> triangulate_region(std::span<Contour const> contours,
                                               std::span<Polyline const> seams = {});

}  // namespace inkflate
