// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/result.h"
#include "cli/pin_list.h"
#include "document/document.h"
#include "pipeline/bend_document.h"

namespace inkflate::cli {

/// A pin may lie this far beside the line that it holds, as a share of the longer side of the canvas: coordinates are read off
/// a picture. One that is farther belongs to another part, or is a slip.
inline constexpr double kPickShare = 0.03;

/// What the pins mean in this document: each on the line of its part, at the place that is nearest.
///
/// out     one move for each pin; hidden parts are bent only where they are named
/// errors  BadInput (index: the pin): no such part, or several of this name; a part without outline; a line that is too far away
Result<std::vector<BendMove>> pin_moves(Document const& document,
                                        std::vector<PinWords> const& pins);

}  // namespace inkflate::cli
