// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/rect.h"
#include "mesh/tri_mesh.h"

namespace inkflate {

/// A place in a mesh: a triangle and the shares of its three corners, which sum to 1.
struct MeshPlace {
  int triangle = 0;
  std::array<double, 3> shares = {};
};

/// Tells in which triangle of a flat mesh a point lies.
///
/// Built in O(n) on square buckets of about two triangles; a query looks at one bucket. Keeps a reference to the mesh.
class TriangleGrid {
 public:
  explicit TriangleGrid(FlatMesh const& mesh);

  Rect const& box() const { return box_; }

  /// The first of the triangles that hold p, edges included; nothing if p lies outside of the mesh.
  std::optional<MeshPlace> find(Vec2 p) const;
  /// All of them, in the mesh's order: of a mesh that lies over itself, or along edges, there are several.
  std::vector<MeshPlace> find_all(Vec2 p) const;

 private:
  /// visit(MeshPlace) for the triangles that hold p, until it returns false.
  template <typename Visit>
  void visit_at(Vec2 p, Visit visit) const;
  int column(double x) const;
  int row(double y) const;

  FlatMesh const& mesh_;
  Rect box_;
  double side_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<int> starts_;  // per bucket, into items_
  std::vector<int> items_;   // triangles
};

/// What values at the mesh's points give at a place, linear within the triangle.
double interpolate(FlatMesh const& mesh, std::vector<double> const& values, MeshPlace const& place);

}  // namespace inkflate
