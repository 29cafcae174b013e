// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "document/document.h"

namespace inkflate {

/// What takes the place of a stroke in its list.
struct StrokeChange {
  int index = 0;
  std::vector<Shared<KeptStroke>> pieces;  // none: the stroke goes
};

/// in      changes: indices ascend strictly
StrokeList with_changes(StrokeList const& strokes, std::span<StrokeChange const> changes);

/// The same for a layer, whose lists name the pieces then as they named the stroke; sources of its outlines that were strokes
/// which have changed lose them.
DocumentLayer with_changes(DocumentLayer const& layer, std::span<StrokeChange const> changes);

}  // namespace inkflate
