// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/editor_state.h"

namespace inkflate {

/// How the Deform tool's drags become a gesture of the document. The bend session solves; it is told of the hand's last place when no
/// event waits, so that a batch of moves costs one frame's work.

/// The hand is there. The first time it takes hold; when there is nothing to hold, that is said and the drag is over.
void bend_towards(EditorTurn& turn, ToolBending const& hand);

/// The session has to follow the hand, or has not settled yet.
bool is_bend_waiting(EditorState const& state);
/// A frame's work of it.
void go_on_bending(EditorTurn& turn);

/// The Deform tool is in the hand, and a press would have to wait for meshes.
bool is_bend_unprepared(EditorState const& state);
/// One part's share of it.
void prepare_bend(EditorState& state);

/// The drag becomes an entry of the history, settled; none when nothing has moved.
void finish_bend(EditorTurn& turn);
/// The drag never was.
void drop_bend(EditorState& state);

/// Larger or smaller by a factor, also in the midst of a drag.
void change_bend_reach(EditorTurn& turn, double factor);

/// How far the next drag reaches where the settings name nothing is known as soon as the part is prepared: of the part that is held, else
/// of the one that is meant.
void follow_reach(EditorTurn& turn);

/// Moves and turns the selected pin at once, as an entry of its own. There has to be one.
void bend_by_pin(EditorTurn& turn, Vec2 delta_px, std::optional<double> turn_rad);

}  // namespace inkflate
