// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

enum class DepthStep { Farther, Nearer, ToBack, ToFront };

/// What the actions on selected layers do to a document. All refuse with NothingThere when nothing is selected or nothing would change.

/// One step counts only past layers that overlap; the order among the selected stays. As Monster Mash does it.
Result<Command> step_depth(Document const& document, std::vector<LayerId> const& selection,
                           DepthStep step);

/// A copy right behind (or before) all others. Where an identical copy lies there already, it is removed instead: a second double
/// click takes back the first.
Result<std::vector<Command>> duplicate_or_remove(Document const& document, LayerId layer,
                                                 OrderEnd end);
/// Copies a little aside, before all others.
Result<std::vector<Command>> duplicate(Document const& document,
                                       std::vector<LayerId> const& selection);

enum class FlipAxis { Horizontal, Vertical };
/// About the middle of their common box.
Result<Command> flip(Document const& document, std::vector<LayerId> const& selection,
                     FlipAxis axis);
Result<Command> nudge(Document const& document, std::vector<LayerId> const& selection,
                      Vec2 delta_px);

/// Moves one layer to a place in the order, counted from the back: for a dragged row of a list.
Result<Command> move_to_index(Document const& document, LayerId layer, int index);

}  // namespace inkflate
