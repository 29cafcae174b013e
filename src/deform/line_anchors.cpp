// SPDX-License-Identifier: Apache-2.0
#include "deform/line_anchors.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "geometry/segment.h"
#include "mesh/triangles_at.h"

namespace inkflate {
namespace {

/// The first triangle with both vertices; -1: none.
int triangle_with(int a, int b, FlatMesh const& mesh, TrianglesAt const& triangles) {
  for (int const t : triangles[a]) {
    auto const& corners = mesh.triangles[t];
    if (std::find(corners.begin(), corners.end(), b) != corners.end()) return t;
  }
  return -1;
}

}  // namespace

LineAnchors::LineAnchors(BendMesh const& mesh) : rest_(&mesh.rest) {
  TrianglesAt const triangles(mesh.rest);
  for (auto const& line : mesh.lines) {
    int const count = static_cast<int>(std::ssize(line.vertices));
    int const edges = line.is_closed || count < 2 ? count : count - 1;
    for (int i = 0; i < edges; ++i) {
      int const from = line.vertices[i];
      int const to = line.vertices[(i + 1) % count];
      int const triangle = triangle_with(from, to, mesh.rest, triangles);
      if (triangle >= 0) edges_.push_back({from, to, triangle});
    }
  }
  CHECK(!edges_.empty(), "a mesh to bend has lines");
}

BendAnchor LineAnchors::nearest(std::span<Vec2 const> pose, Vec2 canvas) const {
  double best = std::numeric_limits<double>::infinity();
  Edge const* found = edges_.data();
  for (auto const& edge : edges_) {
    double const away = squared_distance_to_segment(canvas, pose[edge.from], pose[edge.to]);
    if (!(away < best)) continue;
    best = away;
    found = &edge;
  }
  double const share = share_along(canvas, pose[found->from], pose[found->to]);
  BendAnchor anchor = {found->triangle, {0, 0, 0}};
  auto const& corners = rest_->triangles[found->triangle];
  for (int k = 0; k < 3; ++k) {
    if (corners[k] == found->from) anchor.weights[k] += 1 - share;
    if (corners[k] == found->to) anchor.weights[k] += share;
  }
  return anchor;
}

}  // namespace inkflate
