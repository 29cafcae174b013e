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

/// All that is rough: the layers that take strokes and have some, back to front, then the near loose strokes, then the far ones. Sets without
/// strokes are left out.
std::vector<RoughSet> rough_sets(Document const& document);

/// The strokes of a layer, in their order. Where some are in groups that may become layers, those in other groups, of construction
/// lines and noise, were left out when it was made and are again.
RoughSet layer_set(Document const& document, DocumentLayer const& layer);

/// The set as simplify takes it: stroke i is the one at place i.
Sketch set_sketch(Document const& document, RoughSet const& set);

/// Loose strokes by their groups, where any of them is in one that may become a layer. A layer as one: what is drawn to it belongs to
/// it, whatever groups it was made of.
SimplifyOptions set_options(Sketch const& sketch, RoughSet const& set, CloseChoice const& choice);

/// With which a set of the document is closed.
CloseChoice const& set_choice(Document const& document, RoughSet const& set);

}  // namespace inkflate
