// SPDX-License-Identifier: Apache-2.0
#include "deform/reach.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "mesh/triangles_at.h"

namespace inkflate {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// At the end of a reach, and the share of it from which on it is stiffer or held.
constexpr double kStiffestEnd = 6;
constexpr double kEndShare = 0.5;

// Twice the tether half way through what is held, where area and reach are 1. Less lets more of the shape go along (with a thirtieth there is
// a kink at the end again: 18 degrees instead of 11 for the flat foot of docs/algorithms/ride.md), twice as much bends it more sharply
// (13). At the very end a tether is a hundred times as strong, so that there is no corner to what stays.
constexpr double kTether = 320;
constexpr double kSlackAtEnd = 0.01;

/// Where the last straight stretch of a way starts.
struct Corner {
  Vec2 place;
  double px = 0;  // of the way to there
  Vec2 before;    // the corner before it; of the source itself
};

/// The shortest way known to a vertex.
struct Way {
  double px = kFar;
  Corner last;
};

class WayFinder {
 public:
  explicit WayFinder(FlatMesh const& mesh)
      : mesh_(mesh), ways_(mesh.points.size()), triangles_(mesh) {}

  std::vector<double> run(BendAnchor const& from) {
    Vec2 const source = place_of(mesh_, mesh_.points, from);
    for (int const v : mesh_.triangles[from.triangle]) offer(v, {source, 0, source});
    while (!queue_.empty()) {
      auto const [px, v] = queue_.top();
      queue_.pop();
      if (px > ways_[v].px) continue;  // found a shorter way since
      for (int const t : triangles_[v]) widen(mesh_.triangles[t], v);
    }
    std::vector<double> result;
    for (auto const& way : ways_) result.push_back(way.px);
    return result;
  }

 private:
  void offer(int v, Corner const& corner) {
    double const px = corner.px + distance(corner.place, mesh_.points[v]);
    if (!(px < ways_[v].px)) return;
    ways_[v] = {px, corner};
    queue_.push({px, v});
  }

  /// Goes on from one corner of a triangle to the other two.
  void widen(Triangle const& t, int v) {
    for (int k = 0; k < 3; ++k) {
      int const target = t[k];
      if (target == v) continue;
      int const other = t[(k + 1) % 3] == v ? t[(k + 2) % 3] : t[(k + 1) % 3];
      offer(target, {mesh_.points[v], ways_[v].px, ways_[v].last.place});
      if (ways_[other].px == kFar) continue;
      pass_on(v, other, target);
      pass_on(other, v, target);
    }
  }

  /// The last corner of the way to a becomes that of the target behind the edge from a to b, if it sees it.
  void pass_on(int a, int b, int target) {
    auto const& corner = ways_[a].last;
    auto const& beside = ways_[b].last;
    if (!is_seen(corner.place, a, b, target)) return;
    if (beside.place != corner.place && beside.before == corner.place) {
      // The way to b turns around a corner: what lies on the other side of that than a is hidden.
      Vec2 const shadow = beside.place - corner.place;
      double const side_a = cross(shadow, mesh_.points[a] - corner.place);
      double const side = cross(shadow, mesh_.points[target] - corner.place);
      if (side_a * side < 0) return;
    }
    offer(target, corner);
  }

  /// Whether the straight way from a corner to the target goes through the edge between a and b, or along it.
  bool is_seen(Vec2 corner, int a, int b, int target) const {
    Vec2 const start = mesh_.points[a];
    Vec2 const end = mesh_.points[b];
    Vec2 const goal = mesh_.points[target];
    double const corner_side = cross(end - start, corner - start);
    double const goal_side = cross(end - start, goal - start);
    if (corner_side * goal_side > 0) return false;
    double const side_a = cross(goal - corner, start - corner);
    double const side_b = cross(goal - corner, end - corner);
    return (side_a >= 0 && side_b <= 0) || (side_a <= 0 && side_b >= 0);
  }

  FlatMesh const& mesh_;
  std::vector<Way> ways_;
  TrianglesAt triangles_;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>,
                      std::greater<std::pair<double, int>>>
      queue_;
};

}  // namespace

std::vector<double> ways_inside(FlatMesh const& mesh, BendAnchor const& from) {
  return WayFinder(mesh).run(from);
}

std::vector<double> stiffening_within(FlatMesh const& mesh, std::span<double const> ways_px,
                                      double reach_px) {
  std::vector<double> stiffening;
  for (auto const& [a, b, c] : mesh.triangles) {
    double const share = (ways_px[a] + ways_px[b] + ways_px[c]) / 3 / reach_px;
    double const end = std::clamp((share - kEndShare) / (1 - kEndShare), 0.0, 1.0);
    stiffening.push_back(1 + (kStiffestEnd - 1) * end * end);
  }
  return stiffening;
}

std::vector<double> tethers_within(BendMesh const& mesh, std::span<double const> ways_px,
                                   double reach_px) {
  std::vector<double> tethers(ways_px.size(), 0);
  auto const& rest = mesh.rest;
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    auto const& [a, b, c] = rest.triangles[t];
    double const area = cross(rest.points[b] - rest.points[a], rest.points[c] - rest.points[a]) / 2;
    for (int const v : {a, b, c}) tethers[v] += mesh.stiffness[t] * area / 3;
  }
  for (std::size_t v = 0; v < tethers.size(); ++v) {
    double const share = ways_px[v] / reach_px;
    double const end = share > 1 ? 0 : std::max(0.0, (share - kEndShare) / (1 - kEndShare));
    double const tether = kTether * end * end / (1 + kSlackAtEnd - end);
    tethers[v] = end > 0 ? tether * (tethers[v] / reach_px / reach_px) : 0;
  }
  return tethers;
}

}  // namespace inkflate
