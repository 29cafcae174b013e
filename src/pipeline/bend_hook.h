// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "deform/bend_mesh.h"
#include "geometry/polyline.h"

namespace inkflate {

/// A turn and a shift: p goes to `to` + the turn of (p - from).
struct RigidMotion {
  double cos = 1;
  double sin = 0;
  Vec2 from;
  Vec2 to;

  friend bool operator==(RigidMotion const&, RigidMotion const&) = default;

  bool is_still() const { return cos == 1 && sin == 0 && from == to; }
  /// Exactly p + (to - from) where nothing turns.
  Vec2 operator()(Vec2 p) const;
};

/// The one that brings these points nearest to those; the mean square of the distances counts. Points at one place do not turn.
RigidMotion best_motion(std::span<Vec2 const> points, std::span<Vec2 const> targets);

/// By how much a pose turns the shape at a place, from rest: (-pi, pi].
double turn_at(BendMesh const& mesh, BendPose const& pose, BendAnchor const& at);

/// A place of the canvas that goes with a mesh: inside of it as the mesh does, beside it as the nearest triangle moves and turns.
struct BendHook {
  BendAnchor anchor;
  Vec2 beside;  // from the anchor, as at rest
};

/// The hook that is at this place while the mesh lies in this pose.
/// cost    O(triangles)
BendHook hook_at(BendMesh const& mesh, BendPose const& pose, Vec2 place);

Vec2 place_of(BendMesh const& mesh, BendPose const& pose, BendHook const& hook);

}  // namespace inkflate
