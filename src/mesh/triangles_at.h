// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// The triangles at each vertex of a mesh.
class TrianglesAt {
 public:
  /// cost    O(vertices + triangles)
  explicit TrianglesAt(FlatMesh const& mesh);

  /// Ascending; none where the vertex is in no triangle.
  std::span<int const> operator[](int vertex) const {
    auto const v = static_cast<std::size_t>(vertex);
    return std::span(items_).subspan(starts_[v], starts_[v + 1] - starts_[v]);
  }

 private:
  std::vector<std::size_t> starts_;  // per vertex, into items_
  std::vector<int> items_;
};

}  // namespace inkflate
