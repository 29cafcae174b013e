// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "base/rng.h"
#include "deform/bender.h"
#include "pipeline/bend_rig.h"

namespace inkflate {

/// Some pins, and a place that goes somewhere, all on the outer contour of a mesh.
struct RandomDrag {
  std::vector<Vec2> pins;
  Vec2 from;
  Vec2 to;
};

/// One pin in ten stands where the one before it does. The place that goes is not at a pin: a hand would take the pin.
/// in      mesh: more than 20 px long for each pin
RandomDrag random_drag(BendMesh const& mesh, int pins, double length_px, Rng& rng);

/// A drag of 20 frames and until it rests, with every pin and the handle held at a single place.
/// in      drag: on the bender's mesh
BendPose dragged_by_needle(Bender& bender, RandomDrag const& drag, BendMode mode);

/// A part in the hand of someone with the tool Deform: with its grip, its stages, and what is done when it is let go.
class DeformedPart {
 public:
  /// errors  those of Bender::make
  static Result<DeformedPart> make(std::vector<Outline> outlines, BendOptions const& options = {});

  BendMesh const& mesh() const { return part_->mesh(); }
  /// Drags in 20 frames. Once only.
  void drag(RandomDrag const& drag);
  /// Lets go. out: processor time that it took, ms
  double finish();
  /// Goes on towards the minimum.
  void settle(int steps);
  bool is_settled() const { return rig_->is_settled(); }
  /// The farthest that a pin or the place held is from where it shall be, px.
  double farthest_handle_px() const;
  BendPose pose() const;

 private:
  explicit DeformedPart(Document document);

  Document document_;  // with this part alone
  std::shared_ptr<BendPart> part_;
  std::unique_ptr<BendJoints> joints_;  // of nothing
  std::unique_ptr<BendParts> parts_;
  std::unique_ptr<BendRig> rig_;
  std::vector<Vec2> targets_;  // of the handles
};

/// Where the outer contour of a pose crosses itself.
struct SelfCrossings {
  bool has_sides =
      false;  // opposite sides of one limb: less than 130 px apart at rest, through the shape
  bool has_limbs = false;  // limb over limb
  bool has_kinks = false;  // along one side: as near along the contour as through the shape
};

SelfCrossings self_crossings(BendMesh const& mesh, BendPose const& pose);

/// The outer contour of a pose.
Contour contour_of(BendMesh const& mesh, std::vector<Vec2> const& pose);

}  // namespace inkflate
