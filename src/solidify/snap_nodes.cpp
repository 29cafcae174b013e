// SPDX-License-Identifier: Apache-2.0
#include "solidify/snap_nodes.h"

#include <algorithm>
#include <tuple>

#include "solidify/link.h"

namespace inkflate {
namespace {

// No node moves by a quarter of the lattice's period (0.5) or more, while two opposite edges or a corner and the opposite face of a
// tetrahedron are never closer than twice that: none can turn over. The cuts at a flat base, at 0.25 and 0.5 of a step, are not snapped.
constexpr double kSnapLong = 0.24;
constexpr double kSnapShort = 0.28;

struct Candidate {
  double distance = 0;
  int node = 0;
  int other = 0;
  Vec3 place;
  bool is_of_ball = false;
};

std::vector<Candidate> find_candidates(Solid const& solid, Cuts const& cuts) {
  std::vector<Candidate> candidates;
  auto const offsets = solid.lattice.offsets();
  for (int c = 0; c < cuts.count(); ++c) {
    int const node = cuts.node(c);
    int const d = cuts.direction(c);
    auto const start = solid.lattice.node(node);
    double const share = cuts.share(c);
    double const most = d < kLongDirections ? kSnapLong : kSnapShort;
    if (share > most && 1 - share > most) continue;
    Vec3 const place = place_of(start) + place_of(kSteps[d]) * share;
    int const other = node + offsets[start.k & 1][d];
    double const length = step_length(d);
    bool const is_of_ball = cuts.is_of_ball(c);
    if (share <= most) candidates.push_back({share * length, node, other, place, is_of_ball});
    if (1 - share <= most)
      candidates.push_back({(1 - share) * length, other, node, place, is_of_ball});
  }
  std::sort(candidates.begin(), candidates.end(), [](Candidate const& a, Candidate const& b) {
    return std::tie(a.distance, a.node, a.other) < std::tie(b.distance, b.node, b.other);
  });
  return candidates;
}

class Snapper {
 public:
  explicit Snapper(Solid& solid) : solid_(solid), offsets_(solid.lattice.offsets()) {}

  /// Whether the node could be put on the surface; it is then.
  bool snap(int node) {
    auto const& offsets = offsets_of(node);
    NodeSide const before = solid_.sides[node];
    solid_.sides[node] = NodeSide::On;
    bool is_good = is_disc(link_of(node));
    for (int d = 0; d < kDirections && is_good; ++d) {
      int const other = node + offsets[d];
      if (solid_.sides[other] == NodeSide::On) is_good = is_disc(link_of(other));
    }
    if (!is_good) solid_.sides[node] = before;
    return is_good;
  }

 private:
  std::array<int, kDirections> const& offsets_of(int node) const {
    return offsets_[node / (solid_.lattice.columns * solid_.lattice.rows) & 1];
  }
  LinkSides link_of(int node) const {
    auto const& offsets = offsets_of(node);
    LinkSides link{};
    for (int d = 0; d < kDirections; ++d) link[d] = solid_.sides[node + offsets[d]];
    return link;
  }

  Solid& solid_;
  std::array<std::array<int, kDirections>, 2> offsets_;
};

}  // namespace

SnappedNodes snap_nodes(Solid& solid, Cuts const& cuts) {
  struct Snapped {
    std::int64_t node;
    Vec3 place;
    bool is_of_ball;
  };
  std::vector<Snapped> snapped;
  Snapper snapper(solid);
  for (auto const& candidate : find_candidates(solid, cuts)) {
    if (solid.sides[candidate.node] == NodeSide::On || solid.sides[candidate.other] == NodeSide::On)
      continue;
    if (snapper.snap(candidate.node))
      snapped.push_back({candidate.node, candidate.place, candidate.is_of_ball});
  }
  std::sort(snapped.begin(), snapped.end(),
            [](Snapped const& a, Snapped const& b) { return a.node < b.node; });
  std::vector<std::int64_t> nodes;
  SnappedNodes result;
  for (auto const& each : snapped) {
    nodes.push_back(each.node);
    result.places.push_back(each.place);
    result.is_of_ball.push_back(each.is_of_ball);
  }
  result.nodes = KeyTable(std::move(nodes), solid.lattice.node_count());
  return result;
}

}  // namespace inkflate
