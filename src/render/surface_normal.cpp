// SPDX-License-Identifier: Apache-2.0
#include "render/surface_normal.h"

namespace inkflate {

Vec3 surface_normal(DrawTriangles const& list, SampleGrid const& grid, int triangle, double x,
                    double y) {
  auto const weights = grid.weights(triangle, x, y);
  auto const& corners = list.triangles[static_cast<std::size_t>(triangle)];
  Vec3 sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += weights[k] * list.normals[static_cast<std::size_t>(corners[k])];
  }
  auto normal = normalized(sum);
  // Near silhouettes a smooth normal may point away although the triangle is seen from its front.
  if (grid.is_front(triangle)) {
    if (normal.z < 0) normal = normalized({normal.x, normal.y, 0});
    return normal;
  }
  return normal.z < 0 ? -normal : normalized({-normal.x, -normal.y, 0});
}

}  // namespace inkflate
