// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "deform/bender.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

/// What is bent: a layer, or a rough stroke by itself. The other one is null.
struct BendSource {
  Shared<DocumentLayer> layer = {};
  Shared<KeptStroke> stroke = {};

  friend bool operator==(BendSource const&, BendSource const&) = default;
};

/// Null where the document has none.
Shared<DocumentLayer> layer_of(Document const& document, LayerId layer);
Shared<KeptStroke> stroke_of(Document const& document, StrokeRef const& stroke);

/// Whether outlines, strokes and marks lie at the same places: pins, name and colour may differ.
bool has_same_shape(BendSource const& a, BendSource const& b);

/// A pin and the place of its part that it holds.
struct HeldPin {
  BendPin pin;
  BendAnchor anchor;
  Vec2 beside;  // from the pin to the place held: a pin may stand a little off the line
  double turn_base_rad = 0;  // of pin.turn_rad: how much of it the part had at rest
};

/// A part as one document has it.
struct BendVersion {
  BendSource source;
  BendPose pose = {};  // empty: at rest, without a mesh yet
  std::vector<HeldPin> pins = {};
  std::optional<BendAnchor> loose_end =
      {};                    // the place that was dragged here last, if no pin holds it
  BendPose loose_from = {};  // the pose from which it was dragged; where there is a loose end
  bool is_carried = false;   // what it hangs on or lies on has brought it there, and no hand
};

/// A layer or stroke at rest, its mesh once it is bent, and the poses in which documents have had it.
class BendPart {
 public:
  /// The source is its rest, and what it is now. One of both is there.
  explicit BendPart(BendSource source);

  /// Whether the source is a version of it that is still known. Then it is what the part is now.
  bool meet(BendSource const& source);

  /// Makes the mesh, unless there is one, and finds what the pins hold. Other options than before may differ in their stiffness alone.
  /// errors  those of Bender::make
  std::optional<Error> make_ready(BendOptions const& options);
  bool is_ready() const { return bender_.has_value(); }
  /// Whether make_ready with these options has nothing to make any more.
  bool is_tried(BendOptions const& options) const {
    return (bender_ || fault_) && options.body == options_.body;
  }

  /// Only when it is ready, as all below.
  BendMesh const& mesh() const { return bender_->mesh(); }
  Bender& bender() { return *bender_; }
  BendAnchor nearest(BendPose const& pose, Vec2 place) const {
    return bender_->nearest(pose, place);
  }
  /// What a hand takes hold of: the place itself where that is wanted and the mesh has one there, else the nearest of the line.
  BendAnchor held_at(Vec2 place, bool is_inside) const;
  BendPose const& rest_pose() const { return bender_->rest_pose(); }
  BendVersion const& now() const { return now_; }
  BendOptions const& options() const { return options_; }

  /// A document has it so: what it is now.
  void remember(BendVersion version);
  /// What it is now came of dragging this place, which no pin holds, from a pose.
  void leave_loose(BendAnchor const& place, BendPose from);
  /// Whether that is what came of dragging another place than this, which no pin holds either; none: a pin does.
  bool is_left_loose(std::optional<Vec2> place) const;
  /// The part whose rest is what this one is now; the same one for as long as this one keeps its shape.
  std::shared_ptr<BendPart> const& begun_anew();

  /// It in a pose, as a Bend command has it.
  Bend::Part bent_layer(BendPose const& pose) const;
  Bend::Line bent_stroke(BendPose const& pose, StrokeRef const& stroke) const;
  /// Whether that is what the source is.
  bool is_bent_to(BendSource const& source, BendPose const& pose) const;

 private:
  /// Looks at the pins of the layer as it is now; those that it had when the pose was known hold what they held.
  void anchor_pins();

  std::vector<BendVersion> versions_;  // the first is at rest
  BendVersion now_;
  BendOptions options_;
  std::optional<Bender> bender_;
  std::optional<Error> fault_;      // of Bender::make, with these options
  std::shared_ptr<BendPart> anew_;  // null: was not asked for
};

}  // namespace inkflate
