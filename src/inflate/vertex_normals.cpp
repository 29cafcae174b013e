// SPDX-License-Identifier: Apache-2.0
#include "inflate/vertex_normals.h"

namespace inkflate {

std::vector<Vec3> vertex_normals(TriMesh const& mesh) {
  std::vector<Vec3> normals(mesh.points.size());
  for (auto const& [a, b, c] : mesh.triangles) {
    auto const twice_area = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    for (int const v : {a, b, c}) normals[v] += twice_area;
  }
  for (auto& normal : normals) {
    normal = normalized(normal);
    if (normal == Vec3{}) normal = {0, 0, 1};
  }
  return normals;
}

}  // namespace inkflate
