// SPDX-License-Identifier: Apache-2.0
#include "solidify/point_fans.h"

#include <algorithm>

namespace inkflate {

PointFans::PointFans(TriMesh const& mesh) : mesh_(mesh) {
  begin_.assign(mesh.points.size() + 1, 0);
  for (auto const& triangle : mesh.triangles) {
    for (int const p : triangle) ++begin_[p + 1];
  }
  for (std::size_t p = 1; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
  triangles_.resize(3 * mesh.triangles.size());
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    for (int const p : mesh.triangles[t]) triangles_[next[p]++] = t;
  }
}

Vec3 PointFans::area_vector(int triangle) const {
  auto const& [a, b, c] = mesh_.triangles[triangle];
  auto const& p = mesh_.points;
  return cross(p[b] - p[a], p[c] - p[a]);
}

Vec3 PointFans::middle_around(int point) const {
  // Each neighbour belongs to two triangles of the fan, the point itself to all.
  Vec3 sum;
  for (int const t : around(point)) {
    for (int const q : mesh_.triangles[t]) sum += mesh_.points[q];
  }
  auto const count = static_cast<double>(around(point).size());
  return (sum - mesh_.points[point] * count) / (2 * count);
}

Vec3 PointFans::normal_at(int point) const {
  Vec3 sum;
  for (int const t : around(point)) sum += area_vector(t);
  return normalized(sum);
}

bool PointFans::is_folded(int triangle, double cosine) const {
  Vec3 const normal = normalized(area_vector(triangle));
  auto const& corners = mesh_.triangles[triangle];
  int folds = 0;
  for (int c = 0; c < 3; ++c) {
    int const next = corners[(c + 1) % 3];
    for (int const t : around(corners[c])) {
      auto const& other = mesh_.triangles[t];
      bool const is_neighbour =
          t != triangle && std::find(other.begin(), other.end(), next) != other.end();
      if (is_neighbour && dot(normalized(area_vector(t)), normal) < cosine) ++folds;
    }
  }
  return folds == 3;
}

void PointFans::add_ring(std::vector<int>& points, std::vector<bool>& is_known) const {
  for (std::size_t m = 0, count = points.size(); m < count; ++m) {
    for (int const t : around(points[m])) {
      for (int const q : mesh_.triangles[t]) {
        if (is_known[q]) continue;
        is_known[q] = true;
        points.push_back(q);
      }
    }
  }
}

}  // namespace inkflate
