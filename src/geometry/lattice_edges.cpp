// SPDX-License-Identifier: Apache-2.0
#include "geometry/lattice_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace inkflate {
namespace {

// An edge that was moved may meet another one anew. Two or three rounds are usual.
constexpr int kMostRounds = 64;
// What closed lines of a thousand points with all edges across one another come to.
constexpr std::size_t kMostEdges = 4'000'000;

struct Cut {
  int edge = 0;
  double along = 0;  // where on the edge; exact, only to be compared with others of the same edge
  Vec2 place;
};

/// Exact on the lattice.
double area(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

bool is_inside(Edge const& edge, Vec2 p) {
  if (area(edge.from, edge.to, p) != 0) return false;
  double const along = dot(p - edge.from, edge.to - edge.from);
  return along > 0 && along < squared_norm(edge.to - edge.from);
}

/// The whole point next to where two edges cross inside of both.
std::optional<Vec2> crossing(Edge const& a, Edge const& b) {
  double const from = area(b.from, b.to, a.from);
  double const to = area(b.from, b.to, a.to);
  double const left = area(a.from, a.to, b.from);
  double const right = area(a.from, a.to, b.to);
  bool const is_across = ((from > 0 && to < 0) || (from < 0 && to > 0)) &&
                         ((left > 0 && right < 0) || (left < 0 && right > 0));
  if (!is_across) return std::nullopt;
  auto const place = lerp(a.from, a.to, from / (from - to));
  return Vec2{std::round(place.x), std::round(place.y)};
}

class Cutter {
 public:
  explicit Cutter(std::vector<LatticeEdge> const& edges) {
    for (auto const& each : edges) edges_.push_back(each.edge);
  }

  /// In order of the edges, and along each.
  std::vector<Cut> cuts() && {
    if (edges_.empty()) return {};
    EdgeGrid const grid(edges_);
    grid.any_pair([&](int i, int j) { return meet(i, j); }, [](int, int) { return false; });
    std::sort(cuts_.begin(), cuts_.end(), [](Cut const& a, Cut const& b) {
      if (a.edge != b.edge) return a.edge < b.edge;
      if (a.along != b.along) return a.along < b.along;
      return a.place.x != b.place.x ? a.place.x < b.place.x : a.place.y < b.place.y;
    });
    return std::move(cuts_);
  }

 private:
  /// Notes where a pair has to be cut; more than once where it shares several buckets, which does no harm.
  bool meet(int i, int j) {
    auto const& a = edges_[static_cast<std::size_t>(i)];
    auto const& b = edges_[static_cast<std::size_t>(j)];
    for (auto const p : {b.from, b.to}) {
      if (is_inside(a, p)) add(i, p);
    }
    for (auto const p : {a.from, a.to}) {
      if (is_inside(b, p)) add(j, p);
    }
    if (auto const place = crossing(a, b)) {
      add(i, *place);
      add(j, *place);
    }
    return false;
  }

  void add(int edge, Vec2 place) {
    auto const& [from, to] = edges_[static_cast<std::size_t>(edge)];
    if (place == from || place == to) return;
    cuts_.push_back({edge, dot(place - from, to - from), place});
  }

  std::vector<Edge> edges_;
  std::vector<Cut> cuts_;
};

std::vector<LatticeEdge> pieces(std::vector<LatticeEdge> const& edges,
                                std::vector<Cut> const& cuts) {
  std::vector<LatticeEdge> result;
  result.reserve(edges.size() + cuts.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    auto from = edges[i].edge.from;
    auto const add = [&](Vec2 to) {
      if (from != to) result.push_back({{from, to}, edges[i].tag});
      from = to;
    };
    for (; next < cuts.size() && cuts[next].edge == static_cast<int>(i); ++next) {
      add(cuts[next].place);
    }
    add(edges[i].edge.to);
  }
  return result;
}

}  // namespace

bool cut_where_they_meet(std::vector<LatticeEdge>& edges) {
  for (int round = 0; round < kMostRounds; ++round) {
    auto const cuts = Cutter(edges).cuts();
    if (cuts.empty()) return true;
    if (edges.size() + cuts.size() > kMostEdges) return false;
    edges = pieces(edges, cuts);
  }
  return false;
}

}  // namespace inkflate
