// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "deform/bend_mesh.h"

namespace inkflate {

/// What nothing holds of the pieces of a mesh: a piece without any handle, tether or fixed vertex can be moved and turned at no cost, one that is held at
/// a single place can be turned about it. The energy does not say where such a piece shall be; this does: where it was.
class RigidFreedom {
 public:
  /// mesh: has to outlive this
  explicit RigidFreedom(BendMesh const& mesh);

  /// To be told before the others, and again when anything of the hold changes.
  void set_hold(BendHold const& hold);

  /// Shifts each piece that nothing but a single handle holds so that it is at its target: an exact translation.
  /// out     by how many px, at most
  double shift_to_targets(BendPose& pose) const;

  /// Takes from the moves what only moves or turns a piece that nothing keeps from it.
  void remove_from(std::span<Vec2> moves, std::span<Vec2 const> pose) const;

 private:
  enum class Freedom { All, Turn, None };
  struct Piece {
    std::vector<int> vertices;
    Freedom freedom = Freedom::All;
    BendAnchor centre;     // while Turn: what it can be turned about
    int handle_count = 0;  // while Turn
    Vec2 target;           // of the single handle
  };

  void hold_at(int piece, BendAnchor const& anchor);

  BendMesh const* mesh_;
  std::vector<Piece> pieces_;
  std::vector<int> piece_of_;               // per vertex
  std::vector<BendAnchor> vertex_anchors_;  // per vertex
};

}  // namespace inkflate
