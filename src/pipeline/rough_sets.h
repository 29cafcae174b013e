// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "document/document.h"
#include "simplify/simplify.h"

namespace inkflate {

/// Strokes of a document that are closed together: those of a layer, or loose ones of one depth.
struct RoughSet {
  LayerId layer = LayerId::None;  // None: loose strokes
  StrokeDepth depth = StrokeDepth::Near;
  std::vector<int> places;  // of the strokes, in the list that they are in; ascending
  std::vector<Shared<KeptStroke>> strokes;  // those at the places
};

/// All that is rough: the open layers that have strokes, back to front, then the near loose strokes, then the far ones. Sets without
/// strokes are left out.
std::vector<RoughSet> rough_sets(Document const& document);

/// All strokes of a layer, in their order.
RoughSet layer_set(DocumentLayer const& layer);

/// The set as simplify takes it: stroke i is the one at place i.
Sketch set_sketch(Document const& document, RoughSet const& set);

/// By groups where any of the strokes is in one that may become a layer.
SimplifyOptions set_options(Sketch const& sketch, CloseChoice const& choice);

/// With which a set of the document is closed.
CloseChoice const& set_choice(Document const& document, RoughSet const& set);

}  // namespace inkflate
