// SPDX-License-Identifier: Apache-2.0
#include "solidify/march.h"

#include <algorithm>
#include <array>

namespace inkflate {
namespace {

// A cut this close to a node that could not be moved there is kept away from it, or triangles would have no area. Share of a step.
constexpr double kLeastShare = 0.02;
// Below a quarter of the lattice's period; see snap_nodes.cpp.
constexpr double kMostMove = 0.485;

// The four diagonal steps around the axes, counter-clockwise as seen from the tip.
constexpr std::array<std::array<int, 4>, 3> kAround = {
    {{13, 11, 7, 9}, {13, 9, 8, 12}, {13, 12, 10, 11}}};

struct Corner {
  int node = 0;
  int slot = 0;  // in the tetrahedron; slots 0 and 1, and 2 and 3, are joined by long edges
  NodeSide side = NodeSide::Outside;
};

class Marcher {
 public:
  Marcher(Solid const& solid, Cuts const& cuts, SnappedNodes const& snapped)
      : solid_(solid),
        cuts_(cuts),
        snapped_(snapped),
        offsets_(solid.lattice.offsets()),
        vertex_of_cut_(static_cast<std::size_t>(cuts.count()), -1),
        vertex_of_snapped_(snapped.places.size(), -1) {}

  MarchedMesh run() {
    auto const& lattice = solid_.lattice;
    // Each tetrahedron has one long edge between nodes of even planes. At the rim all is outside.
    for (int k = 2; k + 2 < lattice.planes; k += 2) {
      for (int r = 1; r + 1 < lattice.rows; ++r) {
        int const row = (k * lattice.rows + r) * lattice.columns;
        for (int c = 1; c + 1 < lattice.columns; ++c) {
          for (std::size_t axis = 0; axis < 3; ++axis) march_around(row + c, axis);
        }
      }
    }
    return {std::move(mesh_), std::move(anchors_)};
  }

 private:
  void march_around(int node, std::size_t axis) {
    auto const& sides = solid_.sides;
    int const end = node + offsets_[0][2 * axis];
    std::array<int, 4> around{};
    bool is_mixed = sides[node] != sides[end];
    for (int a = 0; a < 4; ++a) {
      around[a] = node + offsets_[0][kAround[axis][a]];
      is_mixed = is_mixed || sides[around[a]] != sides[node];
    }
    if (!is_mixed) return;
    for (int a = 0; a < 4; ++a) {
      std::array<int, 4> const nodes = {node, end, around[a], around[(a + 1) % 4]};
      march_in(nodes);
    }
  }

  /// Corners sorted inside, outside, on; swapped so that the orientation stays positive.
  void march_in(std::array<int, 4> const& nodes) {
    std::array<Corner, 4> corners{};
    std::array<int, 3> counts{};  // outside, on, inside
    for (int c = 0; c < 4; ++c) {
      corners[c] = {nodes[c], c, solid_.sides[nodes[c]]};
      ++counts[static_cast<int>(corners[c].side) + 1];
    }
    if (counts[2] == 0 || (counts[0] == 0 && counts[1] < 3)) return;
    auto const rank = [](NodeSide side) {
      return side == NodeSide::Inside ? 0 : side == NodeSide::Outside ? 1 : 2;
    };
    bool is_mirrored = false;
    for (int pass = 0; pass < 3; ++pass) {
      for (int c = 0; c + 1 < 4 - pass; ++c) {
        if (rank(corners[c].side) <= rank(corners[c + 1].side)) continue;
        std::swap(corners[c], corners[c + 1]);
        is_mirrored = !is_mirrored;
      }
    }
    is_mirrored_ = is_mirrored;
    cut_off(corners, counts[2], counts[0], nodes);
  }

  void cut_off(std::array<Corner, 4> const& t, int inside, int outside,
               std::array<int, 4> const& nodes) {
    if (outside == 0) {  // one inside, three on the surface
      if (solid_.sides[across(t[0], nodes)] != NodeSide::Inside)
        add({on(t[1]), on(t[2]), on(t[3])});
    } else if (inside == 1) {
      add({cut(t[0], t[1]), t[2].side == NodeSide::On ? on(t[2]) : cut(t[0], t[2]),
           t[3].side == NodeSide::On ? on(t[3]) : cut(t[0], t[3])});
    } else if (inside == 3) {
      add({cut(t[0], t[3]), cut(t[1], t[3]), cut(t[2], t[3])});
    } else if (outside == 1) {
      add({cut(t[0], t[2]), on(t[3]), cut(t[1], t[2])});
    } else {
      add_quad({cut(t[0], t[2]), cut(t[0], t[3]), cut(t[1], t[3]), cut(t[1], t[2])});
    }
  }

  /// The node beyond the face opposite to a corner: its mirror image at the long edge that it is not on.
  int across(Corner const& corner, std::array<int, 4> const& nodes) const {
    auto const& lattice = solid_.lattice;
    int const other = corner.slot < 2 ? 2 : 0;
    return lattice.index(lattice.node(nodes[other]) + lattice.node(nodes[other + 1]) -
                         lattice.node(corner.node));
  }

  int on(Corner const& corner) {
    int const s = snapped_.nodes.find(corner.node);
    if (vertex_of_snapped_[s] < 0)
      vertex_of_snapped_[s] =
          add_point({place_of(solid_.lattice.node(corner.node)), {}, snapped_.is_of_ball[s]},
                    snapped_.places[s]);
    return vertex_of_snapped_[s];
  }

  int cut(Corner const& a, Corner const& b) {
    auto const& lattice = solid_.lattice;
    auto const start = lattice.node(a.node);
    int const c = cuts_.find(a.node, direction(lattice.node(b.node) - start));
    if (vertex_of_cut_[c] < 0) {
      Anchor const anchor{place_of(lattice.node(cuts_.node(c))),
                          place_of(kSteps[cuts_.direction(c)]), cuts_.is_of_ball(c)};
      double const share = std::clamp(cuts_.share(c), kLeastShare, 1 - kLeastShare);
      vertex_of_cut_[c] = add_point(anchor, anchor.node + anchor.step * share);
    }
    return vertex_of_cut_[c];
  }

  static int direction(LatticeNode step) {
    if (step.i % 2 != 0)
      return kLongDirections + (step.i > 0 ? 1 : 0) + (step.j > 0 ? 2 : 0) + (step.k > 0 ? 4 : 0);
    if (step.i != 0) return step.i > 0 ? 0 : 1;
    if (step.j != 0) return step.j > 0 ? 2 : 3;
    return step.k > 0 ? 4 : 5;
  }

  int add_point(Anchor const& anchor, Vec3 place) {
    anchors_.push_back(anchor);
    mesh_.points.push_back(place);
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  void add(Triangle triangle) {
    if (is_mirrored_) std::swap(triangle[1], triangle[2]);
    mesh_.triangles.push_back(triangle);
  }

  /// Along the shorter diagonal.
  void add_quad(std::array<int, 4> const& q) {
    auto const& p = mesh_.points;
    if (squared_norm(p[q[0]] - p[q[2]]) <= squared_norm(p[q[1]] - p[q[3]])) {
      add({q[0], q[1], q[2]});
      add({q[0], q[2], q[3]});
    } else {
      add({q[1], q[2], q[3]});
      add({q[1], q[3], q[0]});
    }
  }

  Solid const& solid_;
  Cuts const& cuts_;
  SnappedNodes const& snapped_;
  std::array<std::array<int, kDirections>, 2> offsets_;
  std::vector<int> vertex_of_cut_;
  std::vector<int> vertex_of_snapped_;
  bool is_mirrored_ = false;
  TriMesh mesh_;
  std::vector<Anchor> anchors_;
};

}  // namespace

Vec3 nearest_allowed(Anchor const& anchor, Vec3 wanted) {
  Vec3 const away = wanted - anchor.node;
  double const size = squared_norm(anchor.step);
  if (size > 0)
    return anchor.node +
           anchor.step * std::clamp(dot(away, anchor.step) / size, kLeastShare, 1 - kLeastShare);
  double const far = norm(away);
  return far <= kMostMove ? wanted : anchor.node + away * (kMostMove / far);
}

MarchedMesh march(Solid const& solid, Cuts const& cuts, SnappedNodes const& snapped) {
  return Marcher(solid, cuts, snapped).run();
}

}  // namespace inkflate
