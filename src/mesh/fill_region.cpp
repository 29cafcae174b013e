// SPDX-License-Identifier: Apache-2.0
#include "mesh/fill_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "mesh/circumcentre.h"

namespace inkflate {
namespace {

// The circle of a finished triangle, as a share of that of one with equal sides of the wanted length.
constexpr double kLargestCircle = 1.35;
// How near a new vertex may come to another one or to a fixed edge, as a share of the wanted length.
constexpr double kLeastGap = 0.6;
constexpr double kLeastGapToLine = 0.5;
constexpr int kMostVertices = 200000;
constexpr double kSqrt3 = 1.7320508075688772;

/// A triangle at the front.
struct Front {
  double
      size;  // of its front edge; the smallest comes first, so that fine parts grow into coarse ones and not the other way
  int serial;
  int triangle;
  int version;  // of the triangle when it was put here

  friend bool operator<(Front const& a, Front const& b) {
    return a.size != b.size ? a.size > b.size : a.serial > b.serial;
  }
};

class Filler {
 public:
  Filler(RegionTriangulation& region, MeshRegionOptions const& options)
      : region_(region), mesh_(region.triangles), options_(options) {
    sizes_.assign(static_cast<std::size_t>(mesh_.vertex_count()), 0);
    for (int v = 0; v < mesh_.given_count(); ++v) sizes_[v] = mean_fixed_edge(v);
    versions_.assign(static_cast<std::size_t>(mesh_.triangle_count()), 0);
    is_settled_.assign(static_cast<std::size_t>(mesh_.triangle_count()), 0);
  }

  void fill() {
    for (int t = 0; t < mesh_.triangle_count(); ++t) look_at(t);
    while (!fronts_.empty() && mesh_.vertex_count() < kMostVertices) {
      auto const front = fronts_.top();
      fronts_.pop();
      if (versions_[front.triangle] != front.version || is_settled_[front.triangle] != 0) continue;
      if (!advance(front.triangle)) settle(front.triangle);
    }
  }

 private:
  double edge_length(int e) const {
    return distance(mesh_.start(e), mesh_.point(mesh_.end_corner(e)));
  }

  double mean_fixed_edge(int v) const {
    double sum = 0;
    int count = 0;
    mesh_.around(v, [&](int e) {
      if (mesh_.is_free(e)) return;
      sum += edge_length(e);
      ++count;
    });
    return sum / count;
  }

  /// The size wanted at a distance from a vertex.
  double size_at(int v, double distance_px) const {
    double const change = options_.growth * distance_px;
    if (sizes_[v] > options_.longest_px) return std::max(options_.longest_px, sizes_[v] - change);
    return std::min(options_.longest_px, sizes_[v] + change);
  }

  /// What a triangle is after it came to be or changed.
  void look_at(int t) {
    ++versions_[t];
    is_settled_[t] = 0;
    if (region_.is_inside[t] == 0) return;
    if (is_small(t)) {
      settle(t);
    } else {
      push_if_at_front(t);
    }
  }

  bool is_small(int t) const {
    int const e = 3 * t;
    auto const a = mesh_.start(e);
    double const radius = distance(a, circumcentre(a, mesh_.start(e + 1), mesh_.start(e + 2)));
    double const size =
        (sizes_[mesh_.corner(e)] + sizes_[mesh_.corner(e + 1)] + sizes_[mesh_.corner(e + 2)]) / 3;
    return radius * kSqrt3 <= kLargestCircle * size;
  }

  void settle(int t) {
    is_settled_[t] = 1;
    for (int e = 3 * t; e < 3 * t + 3; ++e) {
      int const other = mesh_.twin(e) / 3;
      if (region_.is_inside[other] != 0 && is_settled_[other] == 0) push_if_at_front(other);
    }
  }

  bool is_front(int e) const { return !mesh_.is_free(e) || is_settled_[mesh_.twin(e) / 3] != 0; }

  void push_if_at_front(int t) {
    double size = std::numeric_limits<double>::infinity();
    for (int e = 3 * t; e < 3 * t + 3; ++e) {
      if (is_front(e))
        size = std::min(size, std::min(sizes_[mesh_.corner(e)], sizes_[mesh_.end_corner(e)]));
    }
    if (size < std::numeric_limits<double>::infinity())
      fronts_.push({size, next_serial_++, t, versions_[t]});
  }

  /// The front edge from which a triangle is divided: the shortest one whose circle's centre lies before it.
  int front_edge(int t, Vec2 centre) const {
    int best = -1;
    double best_length = std::numeric_limits<double>::infinity();
    for (int e = 3 * t; e < 3 * t + 3; ++e) {
      if (!is_front(e) || edge_length(e) >= best_length) continue;
      auto const along = mesh_.point(mesh_.end_corner(e)) - mesh_.start(e);
      if (cross(along, centre - mesh_.start(e)) <= 0) continue;
      best = e;
      best_length = edge_length(e);
    }
    return best;
  }

  /// The tip of the triangle on e whose circle has the radius of one of the wanted size; no farther than the centre of t's circle.
  Vec2 tip_over(int e, Vec2 centre) const {
    auto const a = mesh_.start(e);
    auto const b = mesh_.point(mesh_.end_corner(e));
    double const half = distance(a, b) / 2;
    auto const middle = (a + b) / 2;
    double const to_centre = distance(middle, centre);
    double size = std::min(size_at(mesh_.corner(e), kSqrt3 * half),
                           size_at(mesh_.end_corner(e), kSqrt3 * half));
    double const farthest = (half * half + to_centre * to_centre) / (2 * to_centre);
    double const radius = std::min(std::max(size / kSqrt3, half), farthest);
    double const height = radius + std::sqrt(std::max(0.0, radius * radius - half * half));
    return middle + normalized(perpendicular(b - a)) * height;
  }

  /// Divides a triangle of the front. False when there is no good place.
  bool advance(int t) {
    int const e0 = 3 * t;
    auto const centre = circumcentre(mesh_.start(e0), mesh_.start(e0 + 1), mesh_.start(e0 + 2));
    int const e = is_finite(centre) ? front_edge(t, centre) : -1;
    if (e < 0) return false;
    auto const p = tip_over(e, centre);
    auto const place = mesh_.locate(p, t);
    if (place.triangle < 0 || place.vertex >= 0) return false;
    if (place.edge >= 0 && !mesh_.is_free(place.edge)) return false;
    auto const size = free_size(p, place.triangle);
    if (size <= 0) return false;
    int const v = mesh_.insert(p, place);
    sizes_.push_back(size);
    auto const count = static_cast<std::size_t>(mesh_.triangle_count());
    region_.is_inside.resize(count, 1);
    versions_.resize(count, 0);
    is_settled_.resize(count, 0);
    mesh_.around(v, [&](int spoke) {
      ++versions_[spoke / 3];
      is_settled_[spoke / 3] = 0;
    });
    mesh_.around(v, [&](int spoke) { look_at(spoke / 3); });
    return true;
  }

  /// The size wanted at p, seen from all vertices that p will be joined to; 0 when p is too near one of them or a fixed edge.
  double free_size(Vec2 p, int t) {
    double size = std::numeric_limits<double>::infinity();
    double nearest = size;
    double nearest_line = size;
    seen_.clear();
    seen_.push_back(t);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      for (int e = 3 * seen_[i]; e < 3 * seen_[i] + 3; ++e) {
        int const v = mesh_.corner(e);
        double const gap = distance(p, mesh_.point(v));
        nearest = std::min(nearest, gap);
        size = std::min(size, size_at(v, gap));
        if (!mesh_.is_free(e)) {
          nearest_line = std::min(
              nearest_line,
              squared_distance_to_segment(p, mesh_.start(e), mesh_.point(mesh_.end_corner(e))));
        } else {
          int const other = mesh_.twin(e) / 3;
          if (std::find(seen_.begin(), seen_.end(), other) == seen_.end() && circle_holds(other, p))
            seen_.push_back(other);
        }
      }
    }
    bool const is_free =
        nearest >= kLeastGap * size && std::sqrt(nearest_line) >= kLeastGapToLine * size;
    return is_free ? size : 0;
  }

  bool circle_holds(int t, Vec2 p) const {
    int const e = 3 * t;
    return DynamicTriangulation::is_in_circle(mesh_.start(e), mesh_.start(e + 1),
                                              mesh_.start(e + 2), p);
  }

  RegionTriangulation& region_;
  DynamicTriangulation& mesh_;
  MeshRegionOptions options_;
  std::vector<double> sizes_;             // per vertex, the wanted length of its edges
  std::vector<int> versions_;             // per triangle
  std::vector<std::uint8_t> is_settled_;  // per triangle: finished, or nothing can be done
  std::priority_queue<Front> fronts_;
  std::vector<int> seen_;
  int next_serial_ = 0;
};

}  // namespace

void fill_region(RegionTriangulation& region, MeshRegionOptions const& options) {
  Filler(region, options).fill();
}

}  // namespace inkflate
