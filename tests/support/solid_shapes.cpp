// SPDX-License-Identifier: Apache-2.0
#include "support/solid_shapes.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/trig.h"

namespace inkflate::shapes {
namespace {

/// A sphere of radius 1 around the origin.
TriMesh unit_sphere(int level) {
  constexpr double golden = 1.618033988749895;
  TriMesh mesh;
  for (double const s : {-1.0, 1.0}) {
    for (double const t : {-golden, golden}) {
      mesh.points.push_back({s, t, 0});
      mesh.points.push_back({0, s, t});
      mesh.points.push_back({t, 0, s});
    }
  }
  // Every three points at mutual distance 2 are a face.
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        auto const& p = mesh.points;
        if (distance(p[a], p[b]) > 2.1 || distance(p[b], p[c]) > 2.1 || distance(p[a], p[c]) > 2.1)
          continue;
        bool const is_out = dot(cross(p[b] - p[a], p[c] - p[a]), p[a]) > 0;
        mesh.triangles.push_back(is_out ? Triangle{a, b, c} : Triangle{a, c, b});
      }
    }
  }
  for (int l = 0; l < level; ++l) {
    std::map<std::pair<int, int>, int> middles;
    auto const middle = [&](int a, int b) {
      auto const [found, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                       static_cast<int>(mesh.points.size()));
      if (is_new) mesh.points.push_back((mesh.points[a] + mesh.points[b]) / 2);
      return found->second;
    };
    std::vector<Triangle> finer;
    for (auto const& [a, b, c] : mesh.triangles) {
      int const ab = middle(a, b);
      int const bc = middle(b, c);
      int const ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
    for (auto& point : mesh.points) point = normalized(point);
  }
  for (auto& point : mesh.points) point = normalized(point);
  return mesh;
}

}  // namespace

TriMesh sphere(Vec3 centre, double radius, int level) {
  TriMesh mesh = unit_sphere(level);
  for (auto& point : mesh.points) point = centre + point * radius;
  return mesh;
}

TriMesh capsule(Vec3 a, Vec3 b, double radius, int level) {
  TriMesh mesh = unit_sphere(level);
  for (auto& point : mesh.points) {
    bool const is_far = dot(point, b - a) > 0;
    point = (is_far ? b : a) + point * radius;
  }
  return mesh;
}

TriMesh box(Vec3 min, Vec3 max) {
  TriMesh mesh;
  for (int c = 0; c < 8; ++c) {
    mesh.points.push_back(
        {(c & 1) != 0 ? max.x : min.x, (c & 2) != 0 ? max.y : min.y, (c & 4) != 0 ? max.z : min.z});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriMesh torus(double ring_radius, double tube_radius, int count) {
  return wrapped(2 * count, count, [&](double u, double v) -> Vec3 {
    auto const ring = sin_cos(2 * kPi * u);
    auto const tube = sin_cos(2 * kPi * v);
    double const out = ring_radius + tube_radius * tube.cos;
    return {out * ring.cos, out * ring.sin, tube_radius * tube.sin};
  });
}

TriMesh together(TriMesh a, TriMesh const& b) {
  int const shift = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (auto const& [p, q, r] : b.triangles)
    a.triangles.push_back({p + shift, q + shift, r + shift});
  return a;
}

TriMesh inside_out(TriMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

double least_angle(TriMesh const& mesh) {
  double largest_cosine = -1;
  for (auto const& corners : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      Vec3 const at = mesh.points[corners[c]];
      Vec3 const u = normalized(mesh.points[corners[(c + 1) % 3]] - at);
      Vec3 const v = normalized(mesh.points[corners[(c + 2) % 3]] - at);
      largest_cosine = std::max(largest_cosine, dot(u, v));
    }
  }
  return acos_of(largest_cosine) * 180 / kPi;
}

}  // namespace inkflate::shapes
