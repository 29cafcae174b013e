// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/tri_mesh.h"

namespace inkflate {

/// A drawn line by the vertices along it.
struct BendLine {
  std::vector<int> vertices;
  bool is_closed = false;
};

/// What resists when a shape is bent: triangles, each with its own stiffness.
struct BendMesh {
  FlatMesh rest;                  // positive area in every triangle
  std::vector<double> stiffness;  // > 0, one per triangle
  std::vector<BendLine> lines;    // the outer contour, then the holes; or each stroke
  double edge_px = 0;             // > 0: of the edges along the lines, about
};

/// Where each vertex of a BendMesh lies now, canvas px.
using BendPose = std::vector<Vec2>;

/// A place of the shape: a triangle of its mesh and the weights of its corners, whose sum is 1. Places a little beside the mesh have a
/// negative weight.
struct BendAnchor {
  int triangle = 0;
  std::array<double, 3> weights = {1, 0, 0};

  friend bool operator==(BendAnchor const&, BendAnchor const&) = default;
};

/// A corner of a triangle, 0 .. 2: the place of that vertex.
BendAnchor corner_anchor(int triangle, int corner);

Vec2 place_of(FlatMesh const& mesh, std::span<Vec2 const> pose, BendAnchor const& anchor);

/// A place of the shape that is held, and where it shall go.
struct BendHandle {
  BendAnchor anchor;
  Vec2 target;  // canvas px
  /// By this the shape around it is turned from its rest, x towards y, within 1e6 rad; none: as it likes.
  std::optional<double> turn_rad = {};
  /// >= 0; mode Body: so far around it the shape is stiffer, as if a fingertip held it and not a needle.
  double grip_px = 0;
  /// > 0; mode Body: of how firmly a handle usually holds. One of far less asks the shape rather than bends it.
  double firmness = 1;
};

/// What holds a shape while it is bent.
struct BendHold {
  std::span<BendHandle const> handles = {};  // any number, also at the same place
  std::span<char const> is_fixed = {};       // per vertex: it stays where it is; empty: none does
  // Per triangle, >= 1; mode Body: how much stiffer it is than the mesh says. Empty: none is.
  std::span<double const> stiffening = {};
  // Per vertex, >= 0; mode Body: to be d px from where it is tethered to costs its tether times d^2. Empty: none is tethered.
  std::span<double const> tethers = {};
  std::span<Vec2 const> tethered_to = {};  // per vertex, where there are tethers
};

/// How far a hand moves a shape: as BendHold has it.
struct BendArea {
  std::vector<char> is_fixed = {};
  std::vector<double> stiffening = {};
  std::vector<double> tethers = {};
};

/// What a shape does towards the end of a reach, beyond which it stays.
enum class ReachEnd {
  Stiff,  // it bends less than elsewhere: the same shape for the same targets, wherever it lay before
  Soft,  // mode Body: it gives way, the less the nearer to the end, so that it bends in a wide round also where it is dragged far
};

/// What a solver has done.
struct BendProgress {
  double energy = 0;           // with the handles' share, after the steps
  double largest_move_px = 0;  // of a vertex in the last step
  bool is_settled = false;     // nothing would move any more that one could see
};

}  // namespace inkflate
