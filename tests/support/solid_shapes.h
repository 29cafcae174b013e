// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mesh/tri_mesh.h"

namespace inkflate::shapes {

/// A closed surface over a grid of count_u x count_v places; `point` gives the place for u, v in 0 .. 1, both of which wrap around.
template <typename Point>
TriMesh wrapped(int count_u, int count_v, Point const& point) {
  TriMesh mesh;
  for (int u = 0; u < count_u; ++u) {
    for (int v = 0; v < count_v; ++v)
      mesh.points.push_back(
          point(static_cast<double>(u) / count_u, static_cast<double>(v) / count_v));
  }
  for (int u = 0; u < count_u; ++u) {
    for (int v = 0; v < count_v; ++v) {
      int const a = u * count_v + v;
      int const b = (u + 1) % count_u * count_v + v;
      int const c = (u + 1) % count_u * count_v + (v + 1) % count_v;
      int const d = u * count_v + (v + 1) % count_v;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// A sphere of 20 * 4^level triangles with its corners on the radius.
TriMesh sphere(Vec3 centre, double radius, int level = 4);
/// A round bar between two points.
TriMesh capsule(Vec3 a, Vec3 b, double radius, int level = 3);
TriMesh box(Vec3 min, Vec3 max);
/// Around the z axis.
TriMesh torus(double ring_radius, double tube_radius, int count = 96);

TriMesh together(TriMesh a, TriMesh const& b);
TriMesh inside_out(TriMesh mesh);

/// The smallest angle of all triangles, degrees.
double least_angle(TriMesh const& mesh);

}  // namespace inkflate::shapes
