// SPDX-License-Identifier: Apache-2.0
#include "geometry/nonzero_boundary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/crossings.h"
#include "geometry/winding_graph.h"

namespace inkflate {
namespace {

// Edges are cut where they meet on a lattice that is coarser by so much than the one on which bridges are built: so that beside every corner
// there is room for them.
constexpr double kFiner = 16;
// Half of what the coarse lattice reaches, so that points that move stay within.
constexpr double kUnitsToSide = kLatticeReach / kFiner / 2;
// Beside a place this many times as far away as the lattice is fine its points would not be numbers any more.
constexpr double kFarthestUnits = 1'125'899'906'842'624;  // 2^50
// Where lines run so close to one another that a bridge finds no room, the next lattice is coarser by kFiner; there they are one.
constexpr int kLattices = 3;
// A corner that gets a bridge has points beside it at most at this share of its edges.
constexpr double kBesideCorner = 0.25;
// Where bridges come into the way of other lines, all are made a quarter as large; after so often they are a few points of the lattice.
constexpr int kTries = 8;

/// Whole points instead of places; both ways exact for points of the lattice.
class Lattice {
 public:
  Lattice(Rect const& box, double units_to_side) {
    int exponent = 0;
    std::frexp(std::max(box.longer_side() / 2 / units_to_side,
                        std::max({std::abs(box.min.x), std::abs(box.max.x), std::abs(box.min.y),
                                  std::abs(box.max.y)}) /
                            kFarthestUnits),
               &exponent);
    unit_px_ = std::ldexp(1, exponent);
    origin_ = whole((box.min + box.max) / (2 * unit_px_)) * unit_px_;
  }

  double fine_px() const { return unit_px_ / kFiner; }
  Vec2 point(Vec2 place) const { return whole((place - origin_) / unit_px_); }
  Vec2 place(Vec2 fine_point) const { return origin_ + fine_point * fine_px(); }

  static Vec2 whole(Vec2 p) { return {std::round(p.x), std::round(p.y)}; }

 private:
  double unit_px_ = 1;
  Vec2 origin_;
};

std::vector<LatticeEdge> lattice_edges(std::span<TaggedContour const> contours,
                                       Lattice const& lattice) {
  std::vector<LatticeEdge> edges;
  for (auto const& [points, tags] : contours) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      Edge const edge = {lattice.point(points[i]), lattice.point(points[(i + 1) % points.size()])};
      if (edge.from != edge.to) edges.push_back({edge, tags[i]});
    }
  }
  return edges;
}

/// An index into a circle of so many points.
std::size_t wrapped(std::ptrdiff_t index, std::size_t count) {
  auto const n = static_cast<std::ptrdiff_t>(count);
  return static_cast<std::size_t>((index % n + n) % n);
}

/// The chain on the fine lattice, with a point on each edge beside a corner that gets a bridge, so that none is in the way of another one.
BoundaryChain with_room(BoundaryChain chain, double reach) {
  for (auto& point : chain.points) point = point * kFiner;
  BoundaryChain roomy;
  auto const add = [&](Vec2 point, int tag, char is_to_bridge) {
    roomy.points.push_back(point);
    roomy.tags.push_back(tag);
    roomy.is_to_bridge.push_back(is_to_bridge);
  };
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    auto const next = (i + 1) % chain.points.size();
    auto const from = chain.points[i];
    auto const to = chain.points[next];
    add(from, chain.tags[i], chain.is_to_bridge[i]);
    double const share = std::min(kBesideCorner, reach / distance(from, to));
    auto const near_from = Lattice::whole(lerp(from, to, share));
    auto const near_to = Lattice::whole(lerp(to, from, share));
    if (chain.is_to_bridge[i] != 0) add(near_from, chain.tags[i], 0);
    if (chain.is_to_bridge[next] != 0) add(near_to, chain.tags[i], 0);
  }
  return roomy;
}

/// How many points to one side of a corner its bridge takes away with the one that it ends on: at most `most`, within reach.
int bridge_steps(BoundaryChain const& chain, int corner, int direction, int most, double reach) {
  auto const at = [&](int steps) {
    return chain.points[wrapped(corner + direction * steps, chain.points.size())];
  };
  int steps = std::min(1, most);
  double way = distance(at(0), at(steps));
  while (steps < most && (way += distance(at(steps), at(steps + 1))) <= reach) ++steps;
  return steps;
}

/// The chain with its bridges: corners cut off, so far along the chain to both sides.
TaggedContour with_bridges(BoundaryChain const& chain, double reach) {
  int const count = static_cast<int>(std::ssize(chain.points));
  std::vector<int> corners;
  for (int i = 0; i < count; ++i) {
    if (chain.is_to_bridge[i] != 0) corners.push_back(i);
  }
  std::vector<char> is_gone(chain.points.size(), 0);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    int const corner = corners[k];
    int const before = k > 0 ? corners[k - 1] : corners.back() - count;
    int const after = k + 1 < corners.size() ? corners[k + 1] : corners.front() + count;
    int const back = bridge_steps(chain, corner, -1, (corner - before - 1) / 2, reach);
    int const ahead = bridge_steps(chain, corner, 1, (after - corner - 1) / 2, reach);
    if (back == 0 || ahead == 0) continue;
    for (int i = corner - back + 1; i < corner + ahead; ++i) {
      is_gone[wrapped(i, chain.points.size())] = 1;
    }
  }
  TaggedContour contour;
  for (int i = 0; i < count; ++i) {
    if (is_gone[i] != 0) continue;
    contour.points.push_back(chain.points[i]);
    contour.tags.push_back(chain.tags[i]);
  }
  return contour;
}

bool are_apart(std::span<TaggedContour const> contours) {
  std::vector<Contour> points;
  for (auto const& contour : contours) points.push_back(contour.points);
  return find_crossings(points, 1).empty();
}

/// None: some still touch.
std::optional<std::vector<TaggedContour>> joined(std::vector<BoundaryChain> const& chains,
                                                 double reach) {
  for (int i = 0; i < kTries; ++i, reach = std::max(reach / 4, kFiner * kBesideCorner)) {
    std::vector<TaggedContour> contours;
    for (auto const& chain : chains) {
      contours.push_back(with_bridges(with_room(chain, reach), reach));
    }
    if (are_apart(contours)) return contours;
  }
  return std::nullopt;
}

std::optional<std::vector<TaggedContour>> boundary_on(Lattice const& lattice,
                                                      std::span<TaggedContour const> contours,
                                                      double bridge_px) {
  auto edges = lattice_edges(contours, lattice);
  if (!cut_where_they_meet(edges)) return std::nullopt;
  auto boundary = joined(boundary_chains(edges), bridge_px / lattice.fine_px() / 2);
  if (!boundary) return std::nullopt;
  for (auto& contour : *boundary) {
    for (auto& point : contour.points) point = lattice.place(point);
  }
  return boundary;
}

}  // namespace

std::optional<std::vector<TaggedContour>> nonzero_boundary(std::span<TaggedContour const> contours,
                                                           double bridge_px) {
  Rect box;
  for (auto const& contour : contours) box = united(box, bounds(contour.points));
  if (box.is_empty() || !(box.longer_side() > 0)) return std::vector<TaggedContour>{};
  double units_to_side = kUnitsToSide;
  for (int i = 0; i < kLattices; ++i, units_to_side /= kFiner) {
    if (auto boundary = boundary_on(Lattice(box, units_to_side), contours, bridge_px)) {
      return boundary;
    }
  }
  return std::nullopt;
}

}  // namespace inkflate
