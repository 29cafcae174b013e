// SPDX-License-Identifier: Apache-2.0
#include "mesh/connected_vertices.h"

#include <algorithm>
#include <numeric>

namespace inkflate {

std::vector<int> connected_vertices(FlatMesh const& mesh) {
  std::vector<int> parents(mesh.points.size());
  std::iota(parents.begin(), parents.end(), 0);
  auto const root_of = [&](int v) {
    while (parents[v] != v) v = parents[v] = parents[parents[v]];
    return v;
  };
  for (auto const& corners : mesh.triangles) {
    for (int k = 1; k < 3; ++k) {
      auto const [low, high] = std::minmax({root_of(corners[0]), root_of(corners[k])});
      parents[high] = low;
    }
  }
  for (int v = 0; v < std::ssize(parents); ++v) parents[v] = root_of(v);
  return parents;
}

}  // namespace inkflate
