// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/bend_mesh.h"
#include "geometry/polyline.h"

namespace inkflate {

/// Finds the place of a mesh's lines that is nearest to a place of the canvas.
class LineAnchors {
 public:
  /// in      mesh: at least one of its lines has a vertex that a triangle has too
  explicit LineAnchors(BendMesh const& mesh);

  /// in      pose: one place per vertex
  /// out     of places equally near the first along the first line
  /// cost    O(points of the lines)
  BendAnchor nearest(std::span<Vec2 const> pose, Vec2 canvas) const;

 private:
  /// An edge of a line; of a line of one vertex that vertex twice.
  struct Edge {
    int from = 0;
    int to = 0;
    int triangle = 0;  // that has both
  };

  FlatMesh const* rest_;
  std::vector<Edge> edges_;
};

}  // namespace inkflate
