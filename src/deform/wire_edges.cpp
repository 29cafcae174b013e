// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_edges.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace inkflate {
namespace {

constexpr double kMostCotangent = 100;  // of 0.6 degrees
constexpr double kLeastCotangent = 0.01;

/// The share that one triangle has in one of its edges.
struct Share {
  int a = 0;
  int b = 0;
  double cotangent = 0;  // of the angle opposite to the edge
  double stiffness = 0;
};

double cotangent(Vec2 u, Vec2 v) {
  double const along = dot(u, v);
  double const across = std::abs(cross(u, v));
  if (std::abs(along) >= kMostCotangent * across)
    return along > 0 ? kMostCotangent : (along < 0 ? -kMostCotangent : 0);
  return along / across;
}

std::vector<Share> shares(BendMesh const& mesh) {
  auto const& p = mesh.rest.points;
  std::vector<Share> result;
  for (int t = 0; t < std::ssize(mesh.rest.triangles); ++t) {
    auto const& corners = mesh.rest.triangles[t];
    for (int k = 0; k < 3; ++k) {
      auto const [a, b] = std::minmax({corners[(k + 1) % 3], corners[(k + 2) % 3]});
      auto const apex = p[corners[k]];
      result.push_back({a, b, cotangent(p[a] - apex, p[b] - apex), mesh.stiffness[t]});
    }
  }
  std::stable_sort(result.begin(), result.end(), [](Share const& s, Share const& t) {
    return std::tie(s.a, s.b) < std::tie(t.a, t.b);
  });
  return result;
}

}  // namespace

std::vector<WireEdge> wire_edges(BendMesh const& mesh) {
  std::vector<WireEdge> edges;
  auto const all = shares(mesh);
  for (std::size_t i = 0; i < all.size();) {
    auto const [a, b, first_cotangent, first_stiffness] = all[i];
    double weight = 0;
    double stiffness = 0;
    for (; i < all.size() && all[i].a == a && all[i].b == b; ++i) {
      weight += all[i].stiffness * all[i].cotangent / 2;
      stiffness += all[i].stiffness / 2;
    }
    weight = std::max(weight, kLeastCotangent * stiffness);
    edges.push_back({a, b, weight, mesh.rest.points[a] - mesh.rest.points[b]});
  }
  return edges;
}

}  // namespace inkflate
