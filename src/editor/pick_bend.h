// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "document/document.h"
#include "editor/pick.h"
#include "editor/view.h"
#include "pipeline/bend_session.h"

namespace inkflate {

/// What the Deform tool can take hold of. Hidden and locked parts cannot be held.

/// The pin under a place of the screen, the nearest of those within reach.
std::optional<BendPinRef> pick_pin(Document const& document, View const& view, Vec2 screen,
                                   double reach_px);

/// How far from a pin its knob lies, px of the screen.
inline constexpr double kPinRingPx = 26;
/// Where the knob lies by which a pin is turned, screen px: above it, turned with it.
Vec2 pin_knob(BendPin const& pin, View const& view);

/// A line, or the inside of a part.
struct BendHit {
  BendGrab what;            // its place lies on the line, or inside
  bool is_on_line = false;  // the line is within reach
};

/// What a place of the canvas means: a rough line within reach; else the nearest line of the parts from the front to the first in which
/// the place lies; else that part. Farthest: from the back.
/// cost    O(pieces) of the parts whose boxes hold the place
std::optional<BendHit> pick_to_bend(Document const& document, Vec2 canvas, double reach_px,
                                    PickDepth depth);

}  // namespace inkflate
