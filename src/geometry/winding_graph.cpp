// SPDX-License-Identifier: Apache-2.0
#include "geometry/winding_graph.h"

#include <algorithm>
#include <tuple>

namespace inkflate {
namespace {

bool is_before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// All edges between the same two points as one.
struct Link {
  int low = 0;  // its ends: indices of points
  int high = 0;
  int turn = 0;  // how many edges run from low to high, less those that run back
  int tag = 0;   // the least
};

/// The links of closed walks as a plane graph. Dart 2 k runs along link k, dart 2 k + 1 against it.
class WindingGraph {
 public:
  explicit WindingGraph(std::span<LatticeEdge const> edges) {
    find_points(edges);
    find_links(edges);
    sort_darts();
    wind();
  }

  std::vector<BoundaryChain> chains() const {
    std::vector<BoundaryChain> result;
    std::vector<char> is_taken(left_.size(), 0);
    std::vector<int> passes(points_.size(), 0);
    for (int d = 0; d < dart_count(); ++d) passes[from(d)] += is_boundary(d) ? 1 : 0;
    for (int first = 0; first < dart_count(); ++first) {
      if (!is_boundary(first) || is_taken[first] != 0) continue;
      BoundaryChain chain;
      for (int d = first; is_taken[d] == 0; d = next(d)) {
        is_taken[d] = 1;
        auto const following = next(d);
        chain.points.push_back(points_[from(following)]);
        chain.tags.push_back(links_[following / 2].tag);
        bool const is_small = cross(ray(d ^ 1), ray(following)) > 0;
        chain.is_to_bridge.push_back(passes[from(following)] > 1 && is_small ? 1 : 0);
      }
      result.push_back(std::move(chain));
    }
    return result;
  }

 private:
  int dart_count() const { return static_cast<int>(2 * std::ssize(links_)); }
  int from(int dart) const { return dart % 2 == 0 ? links_[dart / 2].low : links_[dart / 2].high; }
  int turn(int dart) const {
    return dart % 2 == 0 ? links_[dart / 2].turn : -links_[dart / 2].turn;
  }
  Vec2 ray(int dart) const { return points_[from(dart ^ 1)] - points_[from(dart)]; }
  int right(int dart) const { return left_[dart] - turn(dart); }
  bool is_boundary(int dart) const { return left_[dart] != 0 && right(dart) == 0; }

  void find_points(std::span<LatticeEdge const> edges) {
    for (auto const& each : edges) {
      points_.push_back(each.edge.from);
      points_.push_back(each.edge.to);
    }
    std::sort(points_.begin(), points_.end(), is_before);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  int index_of(Vec2 p) const {
    return static_cast<int>(std::lower_bound(points_.begin(), points_.end(), p, is_before) -
                            points_.begin());
  }

  void find_links(std::span<LatticeEdge const> edges) {
    for (auto const& each : edges) {
      int const a = index_of(each.edge.from);
      int const b = index_of(each.edge.to);
      links_.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1, each.tag});
    }
    std::sort(links_.begin(), links_.end(), [](Link const& a, Link const& b) {
      return std::tie(a.low, a.high, a.tag) < std::tie(b.low, b.high, b.tag);
    });
    std::size_t kept = 0;
    for (std::size_t i = 1; i < links_.size(); ++i) {
      if (links_[i].low == links_[kept].low && links_[i].high == links_[kept].high) {
        links_[kept].turn += links_[i].turn;
      } else {
        links_[++kept] = links_[i];
      }
    }
    if (!links_.empty()) links_.resize(kept + 1);
  }

  bool is_upper(int dart) const {
    auto const along = ray(dart);
    return along.y > 0 || (along.y == 0 && along.x > 0);
  }

  /// Around every point by angle, from the direction of x towards that of y.
  void sort_darts() {
    starts_.assign(points_.size() + 1, 0);
    for (int d = 0; d < dart_count(); ++d) ++starts_[from(d) + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    around_.resize(static_cast<std::size_t>(dart_count()));
    auto free = starts_;
    for (int d = 0; d < dart_count(); ++d) around_[free[from(d)]++] = d;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      std::sort(around_.begin() + starts_[p], around_.begin() + starts_[p + 1], [&](int a, int b) {
        if (is_upper(a) != is_upper(b)) return is_upper(a);
        return cross(ray(a), ray(b)) > 0;
      });
    }
    place_.resize(around_.size());
    for (int i = 0; i < std::ssize(around_); ++i) place_[around_[i]] = i;
  }

  int turned(int dart) const {
    int const point = from(dart);
    int const place = place_[dart] + 1;
    return around_[place < starts_[point + 1] ? place : starts_[point]];
  }

  /// How often all walks wind around what is just left of a point that is the leftmost of its piece.
  int winding_beside(int point) const {
    auto const p = points_[point];
    int winding = 0;
    for (auto const& link : links_) {
      auto const a = points_[link.low];
      auto const b = points_[link.high];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      double const side = cross(b - a, p - a);
      if (b.y > a.y && side < 0) winding -= link.turn;
      if (b.y < a.y && side > 0) winding += link.turn;
    }
    return winding;
  }

  /// Sets what lies left of the darts around a point, given that of one of them; then goes on to the points at their other ends.
  void wind() {
    left_.assign(static_cast<std::size_t>(dart_count()), 0);
    std::vector<char> is_done(points_.size(), 0);
    std::vector<int> todo;  // darts whose left side is known, at points that may be new
    for (int point = 0; point < std::ssize(points_); ++point) {
      if (is_done[point] != 0) continue;
      // The wedge that opens to the left follows after the last dart that does not point up.
      int last = around_[starts_[point + 1] - 1];
      for (int i = starts_[point]; i < starts_[point + 1] && is_upper(around_[i]); ++i) {
        last = around_[i];
      }
      left_[last] = winding_beside(point);
      todo.push_back(last);
      while (!todo.empty()) {
        int const start = todo.back();
        todo.pop_back();
        if (is_done[from(start)] != 0) continue;
        is_done[from(start)] = 1;
        int dart = start;
        do {
          left_[dart ^ 1] = right(dart);
          todo.push_back(dart ^ 1);
          int const next_dart = turned(dart);
          left_[next_dart] = left_[dart] + turn(next_dart);
          dart = next_dart;
        } while (dart != start);
      }
    }
  }

  /// The boundary's dart that follows: the first one after the wedge outside.
  int next(int dart) const {
    int following = turned(dart ^ 1);
    while (!is_boundary(following)) following = turned(following);
    return following;
  }

  std::vector<Vec2> points_;
  std::vector<Link> links_;
  std::vector<int> starts_;  // per point where its darts start in around_
  std::vector<int> around_;
  std::vector<int> place_;  // per dart its place in around_
  std::vector<int> left_;   // per dart how often the walks wind around what is left of it
};

}  // namespace

std::vector<BoundaryChain> boundary_chains(std::span<LatticeEdge const> edges) {
  if (edges.empty()) return {};
  return WindingGraph(edges).chains();
}

}  // namespace inkflate
