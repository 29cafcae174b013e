// SPDX-License-Identifier: Apache-2.0
#include "mesh/triangles_at.h"

#include <numeric>

namespace inkflate {

TrianglesAt::TrianglesAt(FlatMesh const& mesh)
    : starts_(mesh.points.size() + 1, 0), items_(3 * mesh.triangles.size()) {
  for (auto const& triangle : mesh.triangles) {
    for (int const v : triangle) ++starts_[v + 1];
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  auto next = starts_;
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    for (int const v : mesh.triangles[t]) items_[next[v]++] = t;
  }
}

}  // namespace inkflate
