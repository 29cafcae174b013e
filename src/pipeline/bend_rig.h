// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pipeline/bend_hook.h"
#include "pipeline/bend_joints.h"
#include "pipeline/bend_part.h"

namespace inkflate {

/// A part that is taken by hand.
struct BendRoot {
  std::shared_ptr<BendPart> part;        // ready
  std::optional<StrokeRef> stroke = {};  // of a rough stroke
};

/// Parts that are bent together: those held by hand and those that hang on them. Each follows the hosts that come before it in an order
/// in which hosts come before their limbs; a circle of them is cut where it began.
class BendRig {
 public:
  /// in      hanging: layers of parts that are ready; joints: anchored. They have to outlive the rig unchanged, as the parts do
  BendRig(std::vector<BendRoot> const& roots, std::vector<LayerId> const& hanging,
          BendParts const& parts, BendJoints const& joints);

  /// Holds a place of the part of the root'th root. out: the handle; the handles of a part's pins are the pins' indices
  int hold(int root, BendAnchor const& anchor);
  /// How far the first root moves; empty: as a whole.
  void keep_within(BendArea area);
  /// Where a handle is held before it moves.
  Vec2 start(int root, int handle) const;
  /// Where the place that it holds lies now.
  Vec2 end(int root, int handle) const;
  /// Where it shall go; turn_rad: the shape around it, from how it was at the start.
  void move(int root, int handle, Vec2 target, std::optional<double> turn_rad);

  /// Goes on by so many steps of what is held by hand, and half as many of what hangs on it. The places and turns that handles aim at
  /// go towards their targets by a bounded length in each step.
  void step(int steps);
  bool is_settled() const;
  /// Goes on until all is settled, or for as long as one waits who lets go; then snaps. Always the same number of steps for the same rig.
  /// cost    at most about 50 ms for all but huge drawings
  void finish();
  /// Parts that are back where they were, at the start or at rest, as far as one can see, are there to the last bit.
  void snap();
  /// All poses as at the start; handles keep their targets.
  void restart();

  /// One Bend of all that has moved, and SetBendPins of pins that have. Empty: nothing has.
  std::vector<Command> commands() const;
  /// The parts of the document that came of the commands are known in their poses.
  void remember(Document const& result) const;

 private:
  struct Handle {
    BendAnchor anchor;
    Vec2 start;  // of the target
    Vec2 target;
    Vec2 staged;                          // on its way from start to target
    double start_turn_rad = 0;            // all turns: from rest
    std::optional<double> kept_rad = {};  // the pin's, before it was turned by hand
    std::optional<double> turn_rad = {};
    double staged_rad = 0;
  };
  struct Mouth {
    BendJoint const* joint = nullptr;
    int first_handle = 0;
    int host = -1;  // index into parts_; -1: it stays
  };
  struct Part {
    std::shared_ptr<BendPart> part;
    std::optional<StrokeRef> stroke;
    BendPose start;
    BendPose pose;
    std::vector<Handle> handles = {};  // of the pins, then those held by hand, then those of mouths
    int own_handles = 0;               // those that are not of mouths
    std::vector<Mouth> mouths = {};
    BendArea area = {};
    int whole_with = -1;  // index of the part whose motion it shares; -1: it bends
    double grip_px = 0;   // of what is held by hand
    bool is_moved = false;
    bool is_settled = true;
  };

  static Part part_at_start(std::shared_ptr<BendPart> part, std::optional<StrokeRef> stroke);
  static Handle handle_at(Part const& part, BendAnchor const& anchor, Vec2 target);
  void add_layers(std::vector<LayerId> const& layers, std::vector<LayerId> const& hanging,
                  BendParts const& parts, BendJoints const& joints);
  static void add_mouth(Part& part, BendJoint const& joint, BendPart const& host, int moving_host);
  void find_whole();
  int whole_of(Part const& part, int index) const;
  RigidMotion motion_of(Part const& root) const;
  void follow_hosts(Part& part) const;
  void move_whole(Part& part) const;
  static bool is_pulled(Part const& part);
  static void go_along(Part& part);
  static bool advance(Part& part);
  static void bend(Part& part, int steps);
  static std::vector<HeldPin> pins_after(Part const& part);

  std::vector<Part> parts_;  // hosts before their limbs
  std::vector<int> roots_;   // indices into parts_
};

}  // namespace inkflate
