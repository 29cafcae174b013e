// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

enum class DepthStep { Farther, Nearer, ToBack, ToFront };

/// What the actions on selected layers do to a document. All refuse with NothingThere when nothing is selected or nothing would change;
/// ids of layers that do not exist count for nothing.

/// One step counts only past layers that overlap; the order among the selected stays: one that would pass another takes it along.
/// As Monster Mash does it. Layers without outlines overlap where their boxes do.
Result<Command> step_depth(Document const& document, std::vector<LayerId> const& selection,
                           DepthStep step);

/// A copy right behind (or before) all others. Where an identical copy lies behind (or before) the layer already, it is removed
/// instead: a second double click takes back the first.
Result<std::vector<Command>> duplicate_or_remove(Document const& document, LayerId layer,
                                                 OrderEnd end);
/// Copies before all others, in the order that the layers have; their ids follow on from Document::next_id.
std::vector<Command> duplicates(Document const& document, std::vector<LayerId> const& layers,
                                Vec2 offset);
/// The same a little aside, so that they are seen.
Result<std::vector<Command>> duplicate(Document const& document,
                                       std::vector<LayerId> const& selection);

enum class FlipAxis { Horizontal, Vertical };
/// About the middle of their common box. Like nudge it leaves hidden and locked layers where they are.
Result<Command> flip(Document const& document, std::vector<LayerId> const& selection,
                     FlipAxis axis);
/// errors  also BadInput (a distance that is not finite)
Result<Command> nudge(Document const& document, std::vector<LayerId> const& selection,
                      Vec2 delta_px);

/// Moves one layer to a place in the order, counted from the back: for a dragged row of a list. Beyond an end means there.
Result<Command> move_to_index(Document const& document, LayerId layer, int index);

}  // namespace inkflate
