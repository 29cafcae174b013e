// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/mesh_region.h"
#include "mesh/region_triangulation.h"

namespace inkflate {

/// Puts vertices into a region, row by row from its rim and seams inward, until its triangles have the wanted size.
///
/// A front divides finished triangles from those that are too large. The smallest edge of the front gets a vertex of its own: at the
/// tip of a triangle with equal sides, or nearer where something is in the way.
///
/// cost    about 1.5 us per vertex
/// source  Rebay 1993, "Efficient Unstructured Mesh Generation by Means of Delaunay Triangulation and Bowyer-Watson Algorithm"
void fill_region(RegionTriangulation& region, MeshRegionOptions const& options);

}  // namespace inkflate
