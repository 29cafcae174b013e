// SPDX-License-Identifier: Apache-2.0
#include "inflate/point_areas.h"

namespace inkflate {

std::vector<double> point_areas(FlatMesh const& mesh) {
  std::vector<double> areas(mesh.points.size(), 0);
  for (auto const& t : mesh.triangles) {
    Vec2 const a = mesh.points[t[0]];
    double const area = cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a) / 2;
    for (int const v : t) areas[v] += area / 3;
  }
  return areas;
}

}  // namespace inkflate
