// SPDX-License-Identifier: Apache-2.0
#include "support/shell_check.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "geometry/trig.h"

namespace inkflate::shapes {
namespace {

class Pieces {
 public:
  explicit Pieces(int count) : parents_(static_cast<std::size_t>(count)) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }
  int root(int a) {
    while (parents_[a] != a) a = parents_[a] = parents_[parents_[a]];
    return a;
  }
  void join(int a, int b) { parents_[root(a)] = root(b); }

 private:
  std::vector<int> parents_;
};

void measure(TriMesh const& mesh, ShellCheck& check) {
  for (auto const& [a, b, c] : mesh.triangles) {
    std::array<Vec3, 3> const p = {mesh.points[a], mesh.points[b], mesh.points[c]};
    check.volume += dot(p[0], cross(p[1], p[2])) / 6;
    if (!(norm(cross(p[1] - p[0], p[2] - p[0])) > 0)) check.fault = "a triangle without area";
    for (int i = 0; i < 3; ++i) {
      Vec3 const u = p[(i + 1) % 3] - p[i];
      Vec3 const v = p[(i + 2) % 3] - p[i];
      check.least_edge = std::min(check.least_edge, norm(u));
      check.least_angle =
          std::min(check.least_angle, acos_of(dot(u, v) / (norm(u) * norm(v))) * 180 / kPi);
      check.min = {std::min(check.min.x, p[i].x), std::min(check.min.y, p[i].y),
                   std::min(check.min.z, p[i].z)};
      check.max = {std::max(check.max.x, p[i].x), std::max(check.max.y, p[i].y),
                   std::max(check.max.z, p[i].z)};
    }
  }
}

}  // namespace

ShellCheck check_shell(TriMesh const& mesh) {
  ShellCheck check;
  measure(mesh, check);
  std::map<std::pair<int, int>, int> edges;  // directed, and the triangle
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    for (int c = 0; c < 3; ++c) {
      auto const& corners = mesh.triangles[t];
      if (!edges.insert({{corners[c], corners[(c + 1) % 3]}, t}).second)
        check.fault = "an edge with more than two triangles";
    }
  }
  Pieces shells(static_cast<int>(mesh.triangles.size()));
  Pieces fans(3 * static_cast<int>(mesh.triangles.size()));  // corners joined around their points
  auto const corner_at = [&](int t, int point) {
    auto const& corners = mesh.triangles[t];
    return 3 * t +
           static_cast<int>(std::find(corners.begin(), corners.end(), point) - corners.begin());
  };
  for (auto const& [edge, t] : edges) {
    auto const twin = edges.find({edge.second, edge.first});
    if (twin == edges.end()) {
      check.fault = "an edge with one triangle";
      continue;
    }
    shells.join(t, twin->second);
    fans.join(corner_at(t, edge.first), corner_at(twin->second, edge.first));
    fans.join(corner_at(t, edge.second), corner_at(twin->second, edge.second));
  }
  std::vector<int> fan_of_point(mesh.points.size(), -1);
  int used = 0;
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    if (shells.root(t) == t) ++check.shells;
    for (int const p : mesh.triangles[t]) {
      int const fan = fans.root(corner_at(t, p));
      if (fan_of_point[p] < 0) ++used;
      if (fan_of_point[p] >= 0 && fan_of_point[p] != fan) check.fault = "a point with two fans";
      fan_of_point[p] = fan;
    }
  }
  if (used != std::ssize(mesh.points)) check.fault = "a point without triangles";
  check.euler = used - static_cast<long long>(edges.size()) / 2 + std::ssize(mesh.triangles);
  if (!(check.volume > 0)) check.fault = "inside out";
  return check;
}

}  // namespace inkflate::shapes
