// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <vector>

#include "document/document.h"

namespace inkflate {

/// A closed part that lies on another as an eye does on a head.
struct LaidPart {
  LayerId part = LayerId::None;
  LayerId host = LayerId::None;
  Polyline rim;  // places of the part's outer outline, evenly along it, the first one once
};

/// The parts of which at least a third of the rim lies over another part below that is at least twice as large; each with the topmost of
/// those. What is seen lies on what is seen alone.
///
/// in      joined: parts that are left out
/// cost    O(parts^2) boxes; O(pieces) of the outlines of those whose boxes meet
std::vector<LaidPart> laid_parts(Document const& document, std::set<LayerId> const& joined);

}  // namespace inkflate
