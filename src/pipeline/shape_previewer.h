// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "pipeline/close_document.h"
#include "pipeline/rough_sets.h"
#include "simplify/quick_shape.h"

namespace inkflate {

/// Previews of one document after the other, while one draws: of sets of strokes that have not changed it knows the shape.
class ShapePreviewer {
 public:
  /// As preview_shape gives it. Where it was cancelled it knows what it knew before.
  ShapePreview preview(Document const& document, Progress const& progress = {});

 private:
  /// A set, all that its shape depends on, and the shape; an empty one where nothing is closed.
  struct Known {
    RoughSet set;
    CloseChoice choice;
    Shared<std::vector<StrokeGroup>> groups;
    QuickShape shape;
  };

  Known const* find(RoughSet const& set, CloseChoice const& choice, Document const& document) const;

  std::vector<Known> known_;
};

}  // namespace inkflate
