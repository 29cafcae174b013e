// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "geometry/polyline.h"
#include "mesh/tri_mesh.h"

namespace inkflate {

/// An area of the canvas to be meshed.
struct Region {
  std::vector<Contour> contours;  // the outer one, then the holes; simple, disjoint
  std::vector<Polyline>
      seams;  // open lines inside that become edges: simple, disjoint from one another and the contours
};

struct MeshRegionOptions {
  double longest_px = 16;  // > 0; edges deep inside
  double growth = 0.35;    // > 0; px by which edges may grow per px of distance from the rim
};

struct RegionMesh {
  FlatMesh mesh;
  std::vector<std::vector<int>> contours;  // for each contour its points in the mesh, in order
  std::vector<std::vector<int>> seams;     // for each seam its points in the mesh, in order
};

/// A Delaunay mesh of a region with points inside, fine at the rim and coarser in the middle.
///
/// in      region: finite, within 1e6 px. Its contours' and seams' points become vertices as they are, and their edges become edges:
///         sample them first (mesh/rim_spacing.h)
/// out     the contours' points come first, then the seams', then those inside. Every triangle has positive area. Away from
///         corners of the rim sharper than 60 degrees no angle is below 20 degrees. V - E + F = 1 - holes
/// errors  BadInput (a contour or seam crosses or touches itself or another, or has too few points; index: the contour)
/// cost    O(n log n); about 2 ms for 1500 vertices
/// source  docs/algorithms/mesh.md
Result<RegionMesh> mesh_region(Region const& region, MeshRegionOptions const& options = {});

}  // namespace inkflate
