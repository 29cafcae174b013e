// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "document/command.h"
#include "document/document.h"
#include "pipeline/rough_sets.h"

namespace inkflate {

/// Gives loose strokes that draw no shape to the parts below, as someone means who adds whiskers to a face that is closed already: each
/// stroke of which at least half lies on closed layers becomes a detail of the one on which most of it lies. Of layers over one
/// another the foremost counts; hidden and locked ones do not. Help lines and strokes of groups that are no layers stay.
///
/// in      set: of which nothing could be closed. Nothing is done for an open layer
/// out     details grows; the strokes leave the set. Returns how many
/// cost    O(samples of the strokes * outline points of the layers)
int lay_details(Document const& document, RoughSet& set, std::vector<Simplify::Details>& details);

/// The same for strokes that no shape of a closed set names; they leave `closed`.
int lay_details(Document const& document, RoughSet const& set, Simplify::Set& closed,
                std::vector<Simplify::Details>& details);

}  // namespace inkflate
