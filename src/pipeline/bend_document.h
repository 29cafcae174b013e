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

/// Bends parts of a document by all of these at once, from what it is at rest, until nothing moves any more. Layers that join those that
/// move follow by their mouths; pins that a layer has hold it too.
///
/// out     one Bend command, and SetBendPins for pins that have moved
/// errors  BadInput (no such layer, locked, a number that is not finite or too large: index: the move), NothingThere (no move, or
///         nothing moves), BadOption, Cancelled
Result<std::vector<Command>> bend_document(Document const& document,
                                           std::vector<BendMove> const& moves,
                                           BendOptions const& options = {},
                                           Progress const& progress = {});

}  // namespace inkflate
