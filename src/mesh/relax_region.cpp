// SPDX-License-Identifier: Apache-2.0
#include "mesh/relax_region.h"

#include <algorithm>

namespace inkflate {
namespace {

bool joins_rim(DynamicTriangulation const& mesh, int e) {
  return mesh.is_free(e) && mesh.is_rim(mesh.corner(e)) && mesh.is_rim(mesh.end_corner(e));
}

/// The middle of an edge, or beside it, where rounding would leave a triangle without area.
bool split(RegionTriangulation& region, int e) {
  auto& mesh = region.triangles;
  auto const middle = (mesh.start(e) + mesh.point(mesh.end_corner(e))) / 2;
  for (int const apex : {mesh.apex(e), mesh.apex(mesh.twin(e))}) {
    for (double const share : {0.0, 0.25, 0.5}) {
      auto const p = lerp(middle, mesh.point(apex), share);
      if (!mesh.can_split(e, p)) continue;
      mesh.insert(p, {e / 3, e, -1});
      region.is_inside.resize(static_cast<std::size_t>(mesh.triangle_count()), 1);
      return true;
    }
  }
  return false;
}

bool is_alone(DynamicTriangulation const& mesh, int t) {
  return !mesh.is_free(3 * t) && !mesh.is_free(3 * t + 1) && !mesh.is_free(3 * t + 2);
}

bool split_lone(RegionTriangulation& region, int t) {
  auto& mesh = region.triangles;
  auto const centre = (mesh.start(3 * t) + mesh.start(3 * t + 1) + mesh.start(3 * t + 2)) / 3;
  auto const place = mesh.locate(centre, t);
  if (place.triangle != t || place.edge >= 0) return false;
  mesh.insert(centre, place);
  region.is_inside.resize(static_cast<std::size_t>(mesh.triangle_count()), 1);
  return true;
}

/// Of the triangles around v if v stood at p: the least of area / (sum of squared sides), which is largest for equal sides.
double worst_shape(DynamicTriangulation const& mesh, int v, Vec2 p) {
  double worst = 1;
  mesh.around(v, [&](int e) {
    auto const a = mesh.point(mesh.end_corner(e)) - p;
    auto const b = mesh.point(mesh.apex(e)) - p;
    double const sides = squared_norm(a) + squared_norm(b) + squared_norm(b - a);
    worst = std::min(worst, cross(a, b) / sides);
  });
  return worst;
}

void relax_vertex(DynamicTriangulation& mesh, int v) {
  Vec2 sum;
  double count = 0;
  mesh.around(v, [&](int e) {
    sum += mesh.point(mesh.end_corner(e));
    count += 1;
  });
  auto const goal = sum / count;
  constexpr double fair_shape = 0.2;  // of at most 0.289
  double const least = std::min(fair_shape, worst_shape(mesh, v, mesh.point(v)));
  if (worst_shape(mesh, v, goal) >= least && mesh.can_move(v, goal)) mesh.move(v, goal);
}

}  // namespace

bool part_rim(RegionTriangulation& region) {
  auto& mesh = region.triangles;
  mesh.keep_rim_apart();
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    if (region.is_inside[t] != 0 && is_alone(mesh, t)) return split_lone(region, t);
  }
  // Turned edges move to other places in the list, so it is looked through until nothing is found.
  for (bool has_found = true; has_found;) {
    has_found = false;
    for (int e = 0; e < 3 * mesh.triangle_count(); ++e) {
      if (region.is_inside[e / 3] == 0 || !joins_rim(mesh, e)) continue;
      if (!split(region, e)) return false;
      has_found = true;
    }
  }
  return true;
}

void relax_region(RegionTriangulation& region, int passes) {
  auto& mesh = region.triangles;
  int const first_inside = mesh.given_count() + 4;
  for (int pass = 0; pass < passes; ++pass) {
    for (int v = first_inside; v < mesh.vertex_count(); ++v) relax_vertex(mesh, v);
    mesh.make_delaunay();
  }
}

}  // namespace inkflate
