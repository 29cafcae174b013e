// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec3.h"
#include "mesh/tri_mesh.h"

namespace inkflate {

/// What is wrong with a mesh, counted, and what it is.
struct MeshCheck {
  int non_finite_points = 0;
  int bad_indices = 0;            // triangles that name no vertex or one vertex twice
  int boundary_edges = 0;         // with one triangle
  int non_manifold_edges = 0;     // with more than two
  int non_manifold_vertices = 0;  // whose triangles are more than one fan
  int misoriented_edges = 0;      // whose two triangles turn different ways
  int zero_area_triangles = 0;
  int flipped_triangles = 0;   // folded back onto all of their neighbours
  bool is_inside_out = false;  // closed and oriented, but its volume is negative
  int shells = 0;              // connected pieces
  int genus = 0;               // sum over the shells; 0 unless closed and manifold
  long long euler = 0;         // V - E + F, of the vertices that triangles use
  double volume = 0;           // px^3
  Vec3 min;                    // the bounding box
  Vec3 max;

  bool is_closed() const { return boundary_edges == 0; }
  bool is_manifold() const { return non_manifold_edges == 0 && non_manifold_vertices == 0; }
  bool is_oriented() const { return misoriented_edges == 0 && !is_inside_out; }
  bool is_finite() const { return non_finite_points == 0; }
  bool is_sound() const {
    return is_closed() && is_manifold() && is_oriented() && is_finite() && bad_indices == 0 &&
           zero_area_triangles == 0 && flipped_triangles == 0;
  }
};

/// Looks at a mesh of any kind, however damaged. Triangles with bad indices count as that and as nothing else. O(n log n).
MeshCheck check_mesh(TriMesh const& mesh);

/// The mesh with vertices at exactly the same place made one: files repeat vertices along the seams of a texture.
/// Vertices that no triangle uses are left out; triangles stay, bad ones too. O(n log n).
TriMesh weld_vertices(TriMesh const& mesh);

/// Pairs of triangles that pass through each other without sharing a vertex; at most `most` are counted. Triangles that only touch, or
/// lie in one plane, do not count, nor do those with bad indices or points that are not finite.
/// cost    O(n log n) for triangles of similar size
int count_self_crossings(TriMesh const& mesh, int most = 1000);

}  // namespace inkflate
