// SPDX-License-Identifier: Apache-2.0
#include "support/joint_angles.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "geometry/trig.h"

namespace inkflate {
namespace {

/// The model's vertex that a drawn point of a layer became.
int vertex_of(FlatLayer const& layer, int point) {
  for (std::size_t t = 0; t < layer.mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      if (layer.mesh.triangles[t][k] == point) return layer.sheets[0][t][k];
    }
  }
  return -1;
}

std::vector<Vec3> joint_ends(FlatModel const& flat, RestModel const& model) {
  std::vector<Vec3> ends;
  for (auto const& joint : flat.joints) {
    for (int const point : {joint.limb_vertices.front(), joint.limb_vertices.back()}) {
      ends.push_back(model.mesh.points[vertex_of(flat.layers[joint.limb], point)]);
    }
  }
  return ends;
}

}  // namespace

double largest_angle_at_joints(FlatModel const& flat, RestModel const& model, double reach_px) {
  auto const ends = joint_ends(flat, model);
  auto const& points = model.mesh.points;
  auto const normal = [&](int t) {
    auto const& [a, b, c] = model.mesh.triangles[t];
    return normalized(cross(points[b] - points[a], points[c] - points[a]));
  };
  std::map<std::pair<int, int>, int> face_of_edge;
  double least_cosine = 1;
  for (int t = 0; t < static_cast<int>(std::ssize(model.mesh.triangles)); ++t) {
    for (int k = 0; k < 3; ++k) {
      int const a = model.mesh.triangles[t][k];
      int const b = model.mesh.triangles[t][(k + 1) % 3];
      auto const middle = (points[a] + points[b]) / 2;
      bool const is_near = std::any_of(ends.begin(), ends.end(),
                                       [&](Vec3 end) { return distance(end, middle) <= reach_px; });
      if (!is_near) continue;
      auto const found = face_of_edge.find({b, a});
      if (found != face_of_edge.end()) {
        least_cosine = std::min(least_cosine, dot(normal(t), normal(found->second)));
      }
      face_of_edge[{a, b}] = t;
    }
  }
  return acos_of(least_cosine) * 180 / kPi;
}

}  // namespace inkflate
