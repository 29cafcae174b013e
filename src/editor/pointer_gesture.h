// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/route_pointer.h"

namespace inkflate {

/// The steps that route_pointer is made of. Each adds to a step: its state goes on, and what it means is appended.

/// Moves and zooms what the mode shows: the paper or the model.
void change_look(RouteStep& step, View const& view, Vec2 moved_px, Vec2 about, double factor);

/// A pointer that has just come down, the only one at work, begins what its button, the keys held and the mode ask for.
void begin_gesture(RouteStep& step, DownPointer const& pointer, PointerEvent const& event,
                   View const& view);

/// in      event: a move of the pointer that works, or its release; from: where it was before
void move_gesture(RouteStep& step, PointerEvent const& event, Vec2 from, View const& view);

void hover(RouteStep& step, PointerEvent const& event, View const& view);

enum class GestureEnd {
  Keep,  // what was done stays
  Drop,  // it never was
};

/// Whatever the pointers are doing together is over.
void end_gesture(RouteStep& step, GestureEnd end);

/// The same, and the pointers that are down do not count until they are lifted.
void ignore_all(RouteStep& step, GestureEnd end);

/// Farther than this a press was no click.
double click_reach_px(PointerKind kind);

}  // namespace inkflate
