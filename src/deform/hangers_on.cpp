// SPDX-License-Identifier: Apache-2.0
#include "deform/hangers_on.h"

#include <cmath>

#include "mesh/triangles_at.h"

namespace inkflate {
namespace {

// An ear is a few hundredths of a head with its neck; a leg, which should stay, is more of a belly than this.
constexpr double kSmallShare = 0.1;

/// Each vertex' share of the triangles around it, px^2.
std::vector<double> vertex_areas(FlatMesh const& mesh) {
  std::vector<double> areas(mesh.points.size(), 0);
  for (auto const& [a, b, c] : mesh.triangles) {
    auto const& p = mesh.points;
    double const third = cross(p[b] - p[a], p[c] - p[a]) / 6;
    for (int const v : {a, b, c}) areas[v] += third;
  }
  return areas;
}

/// All that stays and hangs together with a vertex, which is marked as seen.
std::vector<int> piece_at(int start, FlatMesh const& mesh, TrianglesAt const& triangles,
                          std::vector<char> const& stays, std::vector<char>& is_seen) {
  std::vector<int> piece = {start};
  is_seen[start] = 1;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (int const t : triangles[piece[i]]) {
      for (int const v : mesh.triangles[t]) {
        if (!stays[v] || is_seen[v]) continue;
        is_seen[v] = 1;
        piece.push_back(v);
      }
    }
  }
  return piece;
}

}  // namespace

void free_hangers_on(FlatMesh const& mesh, std::vector<double> const& way_px,
                     std::vector<char>& stays) {
  auto const areas = vertex_areas(mesh);
  double moving = 0;
  for (std::size_t v = 0; v < areas.size(); ++v) moving += stays[v] ? 0 : areas[v];
  TrianglesAt const triangles(mesh);
  std::vector<char> is_seen(areas.size(), 0);
  std::vector<int> freed;
  for (int v = 0; v < static_cast<int>(std::ssize(areas)); ++v) {
    if (!stays[v] || is_seen[v] || !std::isfinite(way_px[v])) continue;
    auto const piece = piece_at(v, mesh, triangles, stays, is_seen);
    double area = 0;
    for (int const w : piece) area += areas[w];
    if (area < kSmallShare * moving) freed.insert(freed.end(), piece.begin(), piece.end());
  }
  for (int const v : freed) stays[v] = 0;
}

}  // namespace inkflate
