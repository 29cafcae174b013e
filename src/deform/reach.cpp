// SPDX-License-Identifier: Apache-2.0
#include "deform/reach.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace inkflate {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The shortest way known to a vertex: its last straight stretch starts at a corner that is this far away itself.
struct Way {
  double px = kFar;
  Vec2 corner;
  double corner_px = 0;
};

class WayFinder {
 public:
  explicit WayFinder(FlatMesh const& mesh)
      : mesh_(mesh), ways_(mesh.points.size()), starts_(mesh.points.size() + 1, 0) {
    for (auto const& t : mesh.triangles) {
      for (int const v : t) ++starts_[v + 1];
    }
    for (std::size_t v = 1; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
    items_.resize(3 * mesh.triangles.size());
    auto next = starts_;
    for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
      for (int const v : mesh.triangles[t]) items_[next[v]++] = t;
    }
  }

  std::vector<double> run(BendAnchor const& from) {
    Vec2 const source = place_of(mesh_, mesh_.points, from);
    for (int const v : mesh_.triangles[from.triangle]) offer(v, source, 0);
    while (!queue_.empty()) {
      auto const [px, v] = queue_.top();
      queue_.pop();
      if (px > ways_[v].px) continue;  // found a shorter way since
      for (int k = starts_[v]; k < starts_[v + 1]; ++k) widen(mesh_.triangles[items_[k]], v);
    }
    std::vector<double> result;
    for (auto const& way : ways_) result.push_back(way.px);
    return result;
  }

 private:
  void offer(int v, Vec2 corner, double corner_px) {
    double const px = corner_px + distance(corner, mesh_.points[v]);
    if (!(px < ways_[v].px)) return;
    ways_[v] = {px, corner, corner_px};
    queue_.push({px, v});
  }

  /// Goes on from one corner of a triangle to the other two.
  void widen(Triangle const& t, int v) {
    for (int k = 0; k < 3; ++k) {
      int const target = t[k];
      int const other = t[(k + 1) % 3] == v ? t[(k + 2) % 3] : t[(k + 1) % 3];
      if (target == v) continue;
      offer(target, mesh_.points[v], ways_[v].px);
      if (ways_[other].px == kFar) continue;
      if (is_seen(ways_[v].corner, v, other, target))
        offer(target, ways_[v].corner, ways_[v].corner_px);
      if (is_seen(ways_[other].corner, v, other, target))
        offer(target, ways_[other].corner, ways_[other].corner_px);
    }
  }

  /// Whether the straight way from a corner to the target goes through the edge between a and b, or along it.
  bool is_seen(Vec2 corner, int a, int b, int target) const {
    Vec2 const to = mesh_.points[target] - corner;
    double const side_a = cross(to, mesh_.points[a] - corner);
    double const side_b = cross(to, mesh_.points[b] - corner);
    return (side_a >= 0 && side_b <= 0) || (side_a <= 0 && side_b >= 0);
  }

  FlatMesh const& mesh_;
  std::vector<Way> ways_;
  std::vector<int> starts_;  // per vertex, into items_
  std::vector<int> items_;   // the triangles at each vertex
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>,
                      std::greater<std::pair<double, int>>>
      queue_;
};

}  // namespace

std::vector<double> ways_inside(FlatMesh const& mesh, BendAnchor const& from) {
  return WayFinder(mesh).run(from);
}

}  // namespace inkflate
