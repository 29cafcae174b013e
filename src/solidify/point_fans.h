// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// The triangles around each point of a closed mesh. Points may move while it is used, triangles may not change.
class PointFans {
 public:
  explicit PointFans(TriMesh const& mesh);

  std::span<int const> around(int point) const {
    return {triangles_.data() + begin_[point],
            static_cast<std::size_t>(begin_[point + 1] - begin_[point])};
  }
  /// A triangle's normal times twice its area.
  Vec3 area_vector(int triangle) const;
  /// The mean of a point's neighbours.
  Vec3 middle_around(int point) const;
  /// The mean of the normals around a point, by area; of length 1.
  Vec3 normal_at(int point) const;
  /// Whether a triangle turns away from each of its neighbours by more than the angle with this cosine.
  bool is_folded(int triangle, double cosine) const;
  /// Adds all neighbours of the points to them. is_known: per point, whether it is listed already.
  void add_ring(std::vector<int>& points, std::vector<bool>& is_known) const;

 private:
  TriMesh const& mesh_;
  std::vector<int> begin_;  // per point, into triangles_
  std::vector<int> triangles_;
};

}  // namespace inkflate
