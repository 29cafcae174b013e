// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "deform/bend_options.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

/// How much of a part may move when one of its places is dragged.
struct BendReach {
  /// > 0, measured inside the shape: all that is farther stays. None: the whole part.
  std::optional<double> px = {};
};

/// What the hand holds.
struct BendGrab {
  LayerId layer = LayerId::None;  // None: the rough stroke
  std::optional<StrokeRef> stroke = {};
  std::optional<int> pin = {};  // index into the layer's pins; none: the place
  Vec2 place;                   // canvas px, on or near the line
  bool is_inside = false;       // the place itself is held, not the line next to it
};

/// The parts of a document while a person bends them: keeps the rest pose of each until it is told to forget, so that what is dragged
/// back is as it was.
///
/// A part's rest pose is what it was when it was first grabbed. It stays that for every document that came of it by this session's
/// commands, or by undo and redo among those: they are known by the layer that they share. Any other change of the layer, and
/// other options, begin a new rest pose. So does what was dragged by a place without a pin, as soon as another place is taken: else it
/// would spring back.
///
/// What holds a part: its pins; the places where it joins its host, as far as the host has not moved; what lies beyond the reach. With
/// none of these it moves as a whole. Parts that join the one that moves follow it by their mouths.
class BendSession {
 public:
  BendSession();
  ~BendSession();
  BendSession(BendSession&&) noexcept;
  BendSession& operator=(BendSession&&) noexcept;

  /// Makes what a drag needs of the document's parts, one part in each call, so that the next press takes no time, also where it takes another
  /// place than the last one. Drags are the same with and without it, to the last bit. Idle while something is held.
  /// cost    that of Bender::make
  void prepare(Document const& document, BendOptions const& options);
  /// Nothing is left to be prepared. cost: O(1)
  bool is_prepared(Document const& document, BendOptions const& options) const;

  /// Whether a part joins another one, as the document lies there.
  /// cost    that of joined_runs; O(joints) where the document is prepared
  bool is_limb(Document const& document, LayerId layer);

  /// Begins a drag. document: as it is before the drag.
  /// errors  NothingThere (nothing to hold there); BadInput (no such layer, pin or stroke; locked); those of Bender::make
  /// cost    that of Bender::make the first time a part is grabbed; then O(points)
  std::optional<Error> grab(Document const& document, BendGrab const& what, BendReach reach,
                            BendOptions const& options);

  /// The held place goes here, in as many solver steps as a frame has room for. A pin that is turned: by turn_rad from how it was grabbed.
  void drag(Vec2 target, std::optional<double> turn_rad = {});
  /// Another reach, or none, in the midst of a drag: what had moved beyond it goes back.
  void set_reach(BendReach reach);

  bool is_holding() const;
  /// Nothing would move any more: settle is idle.
  bool is_settled() const;
  /// Goes on towards the minimum by four steps of the solver, for which a frame has room.
  void settle();
  /// Settles, in a bounded number of steps: at the end of a drag.
  void finish();

  /// The drag so far, from the document at the grab: one Bend, and SetBendPins where a pin has moved. Empty: nothing has moved.
  std::vector<Command> commands() const;

  /// The drag is over, and the document that came of it is this one: its layers are poses of the same rest. Null: it never was.
  void release(Document const* result);

  /// All rest poses are forgotten: the tool was left.
  void forget();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace inkflate
