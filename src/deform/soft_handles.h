// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "deform/bend_mesh.h"
#include "mesh/triangles_at.h"

namespace inkflate {

/// A place of a mesh that is drawn to a target: strength d^2 at the distance d, and beyond kReachEdges edges only as steep as there.
struct Pull {
  BendAnchor anchor;
  Vec2 target;          // canvas px
  double strength = 0;  // > 0, as a stiffness: no unit

  static constexpr double kReachEdges = 10;
};

/// What handles do to a mesh: each is a pull at its place, and one with a turn has pulls at the vertices around it, too.
///
/// Energies of triangles are px^2, and so are those of pulls: a strength means the same for a drawing of any size.
class SoftHandles {
 public:
  /// The share of one handle without a grip, in stiffnesses of the stiffest triangle: it misses its target by less than 0.5 px in all but absurd drags.
  static constexpr double kStrength = 1000;

  /// mesh: has to outlive the handles. handles: their anchors are in this mesh
  /// cost    O(handles), and O(triangles) once where any has a turn
  SoftHandles(BendMesh const& mesh, std::span<BendHandle const> handles);

  /// Towards the targets and turns themselves.
  std::vector<Pull> pulls() const;
  /// As above, but turned by at most kLargestTurn from how the shape around the handle lies in this pose: a larger turn would lead straight
  /// through its centre.
  std::vector<Pull> pulls_from(std::span<Vec2 const> pose) const;

 private:
  struct RingVertex {
    int vertex = 0;
    BendAnchor anchor;  // that very vertex
    Vec2 arm;           // px, from the handle's place at rest
  };
  struct Turned {
    BendHandle const* handle = nullptr;
    std::vector<RingVertex> ring;
    Vec2 direction;  // cosine and sine of the turn
  };

  void add_turned(std::span<BendHandle const> handles);
  std::vector<RingVertex> ring_around(BendAnchor const& anchor, TrianglesAt const& triangles,
                                      std::vector<char>& is_in) const;
  void add_ring(Turned const& turned, Vec2 direction, std::vector<Pull>& pulls) const;

  BendMesh const* mesh_;
  std::vector<Pull> places_;
  std::vector<Turned> turned_;
  double strength_ = 0;
};

/// The energy of a pull whose place is there.
double pull_energy(Pull const& pull, Vec2 place, double edge_px);
Vec2 pull_gradient(Pull const& pull, Vec2 place, double edge_px);

}  // namespace inkflate
