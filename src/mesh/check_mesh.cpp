// SPDX-License-Identifier: Apache-2.0
#include "mesh/check_mesh.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace inkflate {
namespace {

// Twice the area over the longest side squared: below it rounding decides which way the triangle faces.
constexpr double kLeastFlatness = 1e-12;
// The cosine between a triangle and each of its neighbours from which on it counts as folded back: 120 degrees. The faces of a
// tetrahedron with equal sides turn by 109.5.
constexpr double kFoldedCosine = -0.5;

/// An edge of a triangle, from its lower vertex to its higher one.
struct Side {
  int low;
  int high;
  int triangle;
  int corner;  // where in the triangle it starts
  bool is_upward;

  friend bool operator<(Side const& a, Side const& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.triangle < b.triangle;
  }
};

/// Sets of items that are joined step by step.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }

  int of(int item) {
    while (parents_[item] != item) {
      parents_[item] = parents_[parents_[item]];
      item = parents_[item];
    }
    return item;
  }
  void join(int a, int b) { parents_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<int> parents_;
};

/// The triangles that name three different vertices.
std::vector<Triangle> usable_triangles(TriMesh const& mesh) {
  std::vector<Triangle> usable;
  int const count = static_cast<int>(std::ssize(mesh.points));
  for (auto const& t : mesh.triangles) {
    bool const is_named =
        std::all_of(t.begin(), t.end(), [&](int v) { return v >= 0 && v < count; });
    if (is_named && t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) usable.push_back(t);
  }
  return usable;
}

std::vector<Side> sorted_sides(std::vector<Triangle> const& triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (int t = 0; t < std::ssize(triangles); ++t) {
    for (int i = 0; i < 3; ++i) {
      int const a = triangles[t][i];
      int const b = triangles[t][(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, i, a < b});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Calls visit(sides) with all sides at each edge.
template <typename Visit>
void for_edges(std::vector<Side> const& sides, Visit visit) {
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high)
      ++end;
    visit(std::span(sides).subspan(i, end - i));
    i = end;
  }
}

void count_edges(std::vector<Side> const& sides, MeshCheck& check) {
  for_edges(sides, [&](std::span<Side const> edge) {
    check.euler -= 1;
    if (edge.size() == 1) ++check.boundary_edges;
    if (edge.size() > 2) ++check.non_manifold_edges;
    if (edge.size() == 2 && edge[0].is_upward == edge[1].is_upward) ++check.misoriented_edges;
  });
}

void count_shells(std::vector<Side> const& sides, std::size_t triangle_count, MeshCheck& check) {
  Groups shells(triangle_count);
  for_edges(sides, [&](std::span<Side const> edge) {
    for (auto const& side : edge) shells.join(edge[0].triangle, side.triangle);
  });
  for (int t = 0; t < static_cast<int>(triangle_count); ++t)
    check.shells += shells.of(t) == t ? 1 : 0;
}

/// Corners of triangles at one vertex form a fan when they are joined by edges at that vertex.
void count_fans(std::vector<Side> const& sides, std::vector<Triangle> const& triangles,
                std::size_t vertex_count, MeshCheck& check) {
  Groups fans(3 * triangles.size());
  auto const corner_at = [&](Side const& side, int v) {
    bool const is_start = triangles[side.triangle][side.corner] == v;
    return 3 * side.triangle + (is_start ? side.corner : (side.corner + 1) % 3);
  };
  for_edges(sides, [&](std::span<Side const> edge) {
    for (auto const& side : edge) {
      for (int const v : {side.low, side.high})
        fans.join(corner_at(edge[0], v), corner_at(side, v));
    }
  });
  std::vector<int> counts(vertex_count, 0);
  for (int corner = 0; corner < 3 * std::ssize(triangles); ++corner) {
    if (fans.of(corner) == corner) ++counts[triangles[corner / 3][corner % 3]];
  }
  for (int const count : counts) {
    if (count > 0) check.euler += 1;
    if (count > 1) ++check.non_manifold_vertices;
  }
}

struct Facing {
  Vec3 normal;
  bool has_area = false;
};

std::vector<Facing> facings(TriMesh const& mesh, std::vector<Triangle> const& triangles,
                            MeshCheck& check) {
  std::vector<Facing> result;
  result.reserve(triangles.size());
  for (auto const& [a, b, c] : triangles) {
    auto const p = mesh.points[b] - mesh.points[a];
    auto const q = mesh.points[c] - mesh.points[a];
    double const longest = std::max({squared_norm(p), squared_norm(q), squared_norm(q - p)});
    auto const normal = cross(p, q);
    bool const has_area = norm(normal) > kLeastFlatness * longest;
    bool const is_known =
        is_finite(mesh.points[a]) && is_finite(mesh.points[b]) && is_finite(mesh.points[c]);
    if (is_known && !has_area) ++check.zero_area_triangles;
    result.push_back({normalized(normal), is_known && has_area});
  }
  return result;
}

void count_flipped(TriMesh const& mesh, std::vector<Side> const& sides,
                   std::vector<Triangle> const& triangles, MeshCheck& check) {
  auto const facing = facings(mesh, triangles, check);
  std::vector<int> folded(triangles.size(), 0);
  for_edges(sides, [&](std::span<Side const> edge) {
    if (edge.size() != 2) return;
    auto const& a = facing[edge[0].triangle];
    auto const& b = facing[edge[1].triangle];
    if (!a.has_area || !b.has_area || dot(a.normal, b.normal) > kFoldedCosine) return;
    ++folded[edge[0].triangle];
    ++folded[edge[1].triangle];
  });
  for (int const count : folded) check.flipped_triangles += count == 3 ? 1 : 0;
}

void measure(TriMesh const& mesh, std::vector<Triangle> const& triangles, MeshCheck& check) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec3 low = {far, far, far};
  Vec3 high = -low;
  for (auto const& p : mesh.points) {
    if (!is_finite(p)) {
      ++check.non_finite_points;
      continue;
    }
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  if (low.x > high.x) return;
  check.min = low;
  check.max = high;
  // From the middle of the mesh, so that a place far from the origin costs no digits.
  auto const middle = low / 2 + high / 2;
  for (auto const& [a, b, c] : triangles) {
    double const part =
        dot(mesh.points[a] - middle, cross(mesh.points[b] - middle, mesh.points[c] - middle)) / 6;
    if (std::isfinite(part)) check.volume += part;
  }
}

}  // namespace

MeshCheck check_mesh(TriMesh const& mesh) {
  MeshCheck check;
  auto const triangles = usable_triangles(mesh);
  auto const sides = sorted_sides(triangles);
  check.bad_indices = static_cast<int>(mesh.triangles.size() - triangles.size());
  check.euler = std::ssize(triangles);
  measure(mesh, triangles, check);
  count_edges(sides, check);
  count_shells(sides, triangles.size(), check);
  count_fans(sides, triangles, mesh.points.size(), check);
  count_flipped(mesh, sides, triangles, check);
  check.is_inside_out = check.is_closed() && check.misoriented_edges == 0 && check.volume < 0;
  if (check.is_closed() && check.is_manifold())
    check.genus = static_cast<int>(check.shells - check.euler / 2);
  return check;
}

}  // namespace inkflate
