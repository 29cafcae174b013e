// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "deform/bend_options.h"
#include "document/command.h"
#include "document/document.h"

namespace inkflate {

/// A place of a part, and where it shall go. One that goes nowhere is a pin: it stays.
struct BendMove {
  LayerId layer = LayerId::None;
  Vec2 from;                            // canvas px; the nearest place of the layer's line is held
  Vec2 to;                              // canvas px
  std::optional<double> turn_rad = {};  // the line around it is turned by this
};

/// What bend_document makes.
struct BentDocument {
  std::vector<Command> commands;  // one Bend, and SetBendPins for pins that have moved
  std::vector<Vec2> ends;         // of each move: where the place that it holds has come to
  int steps = 0;                  // of the solver, at most
  bool is_settled = false;        // nothing would move any more
};

/// Bends parts of a document by all of these at once, from what it is at rest, until nothing moves any more. Layers that join those that
/// move follow by their mouths; pins that a layer has hold it too.
///
/// errors  BadInput (no such layer, locked, a number that is not finite or too large: index: the move), NothingThere (no move, or
///         nothing moves), BadOption, Cancelled
/// cost    meshes of what moves, and up to 400 steps of their solvers: some 0.1 s for a character
Result<BentDocument> bend_document(Document const& document, std::vector<BendMove> const& moves,
                                   BendOptions const& options = {}, Progress const& progress = {});

}  // namespace inkflate
