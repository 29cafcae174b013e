// SPDX-License-Identifier: Apache-2.0
#include "deform/line_anchors.h"

#include <algorithm>
#include <limits>

#include "base/check.h"

namespace inkflate {
namespace {

/// The triangles at each vertex, side by side.
struct TrianglesAt {
  explicit TrianglesAt(FlatMesh const& mesh)
      : starts(mesh.points.size() + 1, 0), items(3 * mesh.triangles.size()) {
    for (auto const& t : mesh.triangles) {
      for (int const v : t) ++starts[v + 1];
    }
    for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
    auto next = starts;
    for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
      for (int const v : mesh.triangles[t]) items[next[v]++] = t;
    }
  }

  /// The first triangle with both vertices; -1: none.
  int find(FlatMesh const& mesh, int a, int b) const {
    for (int k = starts[a]; k < starts[a + 1]; ++k) {
      auto const& t = mesh.triangles[items[k]];
      if (t[0] == b || t[1] == b || t[2] == b) return items[k];
    }
    return -1;
  }

  std::vector<int> starts;
  std::vector<int> items;
};

}  // namespace

LineAnchors::LineAnchors(BendMesh const& mesh) : rest_(&mesh.rest) {
  TrianglesAt const triangles(mesh.rest);
  for (auto const& line : mesh.lines) {
    int const count = static_cast<int>(std::ssize(line.vertices));
    int const edges = line.is_closed || count < 2 ? count : count - 1;
    for (int i = 0; i < edges; ++i) {
      int const from = line.vertices[i];
      int const to = line.vertices[(i + 1) % count];
      int const triangle = triangles.find(mesh.rest, from, to);
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
  Vec2 const along = pose[found->to] - pose[found->from];
  double const square = squared_norm(along);
  double const share =
      square > 0 ? std::clamp(dot(canvas - pose[found->from], along) / square, 0.0, 1.0) : 0;
  BendAnchor anchor = {found->triangle, {0, 0, 0}};
  auto const& corners = rest_->triangles[found->triangle];
  for (int k = 0; k < 3; ++k) {
    if (corners[k] == found->from) anchor.weights[k] += 1 - share;
    if (corners[k] == found->to) anchor.weights[k] += share;
  }
  return anchor;
}

}  // namespace inkflate
