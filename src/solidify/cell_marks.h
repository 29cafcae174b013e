// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// Marks on cells of space, set and read through the triangles that touch them.
class CellMarks {
 public:
  /// mesh: at least one point. cell: their side; a memory of (size of the mesh / cell)^3 bits.
  CellMarks(TriMesh const& mesh, double cell) : mesh_(mesh), cell_(cell), low_(mesh.points[0]) {
    Vec3 high = low_;
    for (auto const& p : mesh.points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    size_ = cell_of(high);
    for (int& size : size_) ++size;
    marks_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], false);
  }

  void mark(int triangle) {
    visit(triangle, [&](std::size_t cell) { marks_[cell] = true; });
  }
  bool is_marked(int triangle) const {
    bool result = false;
    visit(triangle, [&](std::size_t cell) { result = result || marks_[cell]; });
    return result;
  }

 private:
  using Cell = std::array<int, 3>;

  Cell cell_of(Vec3 p) const {
    auto const whole = [&](double x) { return static_cast<int>(x / cell_); };
    return {whole(p.x - low_.x), whole(p.y - low_.y), whole(p.z - low_.z)};
  }

  /// The cells of a triangle's bounding box.
  template <typename OnCell>
  void visit(int triangle, OnCell const& on_cell) const {
    auto const& corners = mesh_.triangles[triangle];
    Cell first = cell_of(mesh_.points[corners[0]]);
    Cell last = first;
    for (int const p : corners) {
      Cell const cell = cell_of(mesh_.points[p]);
      for (int axis = 0; axis < 3; ++axis) {
        first[axis] = std::min(first[axis], cell[axis]);
        last[axis] = std::max(last[axis], cell[axis]);
      }
    }
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int x = first[0]; x <= last[0]; ++x)
          on_cell((static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x);
      }
    }
  }

  TriMesh const& mesh_;
  double cell_;
  Vec3 low_;
  Cell size_{};
  std::vector<bool> marks_;
};

}  // namespace inkflate
