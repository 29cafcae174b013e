// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/route_pointer.h"

namespace inkflate {

/// What fingers do together, and when they are none. Parts of route_pointer; each adds to a step.

/// A finger comes down: beside a working pen or mouse it is ignored; alone it begins a gesture; the second one makes it a pinch.
void press_finger(RouteStep& step, DownPointer finger, PointerEvent const& event, View const& view);

/// in      index: of the finger in down, whose place is still the one before; event: its move or release
void move_pinch(RouteStep& step, int index, PointerEvent const& event, View const& view);

enum class FingerEnd {
  Lifted,
  Lost,  // cancelled, or its release never came
};

/// A finger that counted is no longer down: the pinch ends, or it was a tap of two or three.
void lift_finger(RouteStep& step, FingerEnd end);

/// The finger has moved, or time has passed: it may be no tap any more.
void watch_tap(PointerState& state, DownPointer const& finger);

/// A pen is there: fingers that have just come down are the palm of its hand.
void reject_palms(RouteStep& step);

}  // namespace inkflate
