// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <vector>

#include "document/document.h"

namespace inkflate {

/// A closed part that lies on another as an eye does on a head, or is tucked behind it as a far leg.
struct LaidPart {
  LayerId part = LayerId::None;
  LayerId host = LayerId::None;
  Polyline rim = {};  // of the part's outer outline, evenly along it: where both overlap
};

/// The parts of which at least a twelfth of the rim lies over another part that is larger, or below one that is four times as large; each
/// with the one that has most of it, of several the nearest below, or else above. What is seen lies on what is seen alone.
///
/// in      joined: parts that are left out
/// cost    O(parts^2) boxes; O(pieces) of the outlines of those whose boxes meet
std::vector<LaidPart> laid_parts(Document const& document, std::set<LayerId> const& joined);

}  // namespace inkflate
