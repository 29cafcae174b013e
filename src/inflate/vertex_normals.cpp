// SPDX-License-Identifier: Apache-2.0
#include "inflate/vertex_normals.h"

namespace inkflate {

namespace {

Vec3 or_forward(Vec3 normal) { return normal == Vec3{} ? Vec3{0, 0, 1} : normal; }

// Near a rim the surface bends within one triangle, and which way each facet looks depends on how the mesh happens to lie: without
// smoothing the shading shows ripples there.
constexpr int kPasses = 4;

/// Each normal becomes the mean of itself and those around it.
std::vector<Vec3> smoothed(TriMesh const& mesh, std::vector<Vec3> const& normals) {
  std::vector<Vec3> sums(normals.size());
  for (auto const& [a, b, c] : mesh.triangles) {
    auto const sum = normals[a] + normals[b] + normals[c];
    for (int const v : {a, b, c}) sums[v] += sum;
  }
  for (auto& normal : sums) normal = or_forward(normalized(normal));
  return sums;
}

}  // namespace

std::vector<Vec3> vertex_normals(TriMesh const& mesh) {
  std::vector<Vec3> normals(mesh.points.size());
  for (auto const& [a, b, c] : mesh.triangles) {
    auto const twice_area = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    for (int const v : {a, b, c}) normals[v] += twice_area;
  }
  for (auto& normal : normals) normal = or_forward(normalized(normal));
  for (int pass = 0; pass < kPasses; ++pass) normals = smoothed(mesh, normals);
  return normals;
}

}  // namespace inkflate
