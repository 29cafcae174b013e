// SPDX-License-Identifier: Apache-2.0
#include "inflate/unfold.h"

#include <algorithm>
#include <array>

namespace inkflate {
namespace {

constexpr int kMostRounds = 40;
// What does not unfold is taken hold of more widely.
constexpr int kRoundsPerRing = 4;
// Steeper than 120 degrees against all neighbours: what check_mesh calls flipped, and a little more so that rounding to files is harmless.
constexpr double kFoldedCosine = -0.45;

/// An edge of one of the triangles.
struct HalfEdge {
  std::array<int, 2> ends;  // the smaller vertex first
  int triangle = 0;
};

std::vector<int> movable_triangles(std::span<Triangle const> triangles,
                                   std::vector<bool> const& is_movable) {
  std::vector<int> list;
  for (int t = 0; t < static_cast<int>(std::ssize(triangles)); ++t) {
    auto const& [a, b, c] = triangles[t];
    if (is_movable[a] || is_movable[b] || is_movable[c]) list.push_back(t);
  }
  return list;
}

/// Pairs of neighbours, as indices into the list.
std::vector<std::array<int, 2>> neighbours(std::span<Triangle const> triangles,
                                           std::vector<int> const& list) {
  std::vector<HalfEdge> edges;
  for (int i = 0; i < static_cast<int>(std::ssize(list)); ++i) {
    auto const& corners = triangles[list[i]];
    for (int k = 0; k < 3; ++k) {
      int const a = corners[k];
      int const b = corners[(k + 1) % 3];
      edges.push_back({{std::min(a, b), std::max(a, b)}, i});
    }
  }
  std::sort(edges.begin(), edges.end(), [](HalfEdge const& a, HalfEdge const& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle;
  });
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].ends == edges[i - 1].ends)
      pairs.push_back({edges[i - 1].triangle, edges[i].triangle});
  }
  return pairs;
}

std::vector<int> folded_triangles(std::span<Triangle const> triangles, std::vector<int> const& list,
                                  std::vector<std::array<int, 2>> const& pairs,
                                  std::vector<Vec3> const& points) {
  std::vector<Vec3> normals;
  for (int const t : list) {
    auto const& [a, b, c] = triangles[t];
    normals.push_back(normalized(cross(points[b] - points[a], points[c] - points[a])));
  }
  std::vector<int> against(list.size(), 0);
  for (auto const& [a, b] : pairs) {
    if (dot(normals[a], normals[b]) > kFoldedCosine) continue;
    ++against[a];
    ++against[b];
  }
  std::vector<int> folded;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (against[i] == 3) folded.push_back(list[i]);
  }
  return folded;
}

/// The movable corners of the folded triangles, and those around them up to so many rings away.
std::vector<bool> vertices_to_move(std::span<Triangle const> triangles,
                                   std::vector<int> const& list, std::vector<int> const& folded,
                                   std::vector<bool> const& is_movable, int rings) {
  std::vector<bool> is_moving(is_movable.size(), false);
  for (int const t : folded) {
    for (int const v : triangles[t]) is_moving[v] = is_movable[v];
  }
  for (int ring = 0; ring < rings; ++ring) {
    auto const inner = is_moving;
    for (int const t : list) {
      auto const& [a, b, c] = triangles[t];
      if (!inner[a] && !inner[b] && !inner[c]) continue;
      for (int const v : {a, b, c}) is_moving[v] = is_movable[v];
    }
  }
  return is_moving;
}

void move_to_neighbours(std::span<Triangle const> triangles, std::vector<int> const& list,
                        std::vector<bool> const& is_moving, std::vector<Vec3>& points) {
  std::vector<Vec3> sums(points.size());
  std::vector<int> counts(points.size(), 0);
  for (int const t : list) {
    for (int k = 0; k < 3; ++k) {
      int const v = triangles[t][k];
      if (!is_moving[v]) continue;
      sums[v] += points[triangles[t][(k + 1) % 3]];
      ++counts[v];
    }
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (counts[v] > 0) points[v] = sums[v] / static_cast<double>(counts[v]);
  }
}

}  // namespace

void unfold(std::span<Triangle const> triangles, std::vector<bool> const& is_movable,
            std::vector<Vec3>& points) {
  auto const list = movable_triangles(triangles, is_movable);
  auto const pairs = neighbours(triangles, list);
  for (int round = 0; round < kMostRounds; ++round) {
    auto const folded = folded_triangles(triangles, list, pairs, points);
    if (folded.empty()) return;
    int const rings = round / kRoundsPerRing;
    move_to_neighbours(triangles, list,
                       vertices_to_move(triangles, list, folded, is_movable, rings), points);
  }
}

}  // namespace inkflate
