// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/bend_mesh.h"

namespace inkflate {

/// A linear map of the plane by what it makes of the two axes.
struct Linear2 {
  Vec2 x;
  Vec2 y;

  Vec2 operator()(Vec2 v) const { return x * v.x + y * v.y; }
};

/// How a vertex has moved from rest, and how what is around it has changed: the Jacobian less the identity.
struct VertexMotion {
  Vec2 shift;
  Linear2 change;
};

/// Measures how a mesh's vertices have moved in a pose. What has not moved has motions of exact zeros.
///
/// A vertex' change is the mean of those of its triangles by area; along a line it is that between its neighbours there, so that
/// lines are smooth.
class MotionField {
 public:
  /// in      mesh: has to outlive the field
  explicit MotionField(BendMesh const& mesh);

  /// in      pose: one place per vertex
  /// cost    O(n)
  std::vector<VertexMotion> motions(std::span<Vec2 const> pose) const;

 private:
  struct LineVertex {
    int vertex = 0;
    int before = 0;  // vertices; itself at an end of the line
    int after = 0;
    Vec2 direction;        // from before to after, length 1
    double length_px = 0;  // > 0, from before to after
  };

  void add_line(BendLine const& line);

  FlatMesh const* rest_;
  std::vector<double> areas_;  // per vertex, twice those of its triangles together
  std::vector<LineVertex> line_vertices_;
};

}  // namespace inkflate
