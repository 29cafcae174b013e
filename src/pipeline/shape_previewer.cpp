// SPDX-License-Identifier: Apache-2.0
#include "pipeline/shape_previewer.h"

#include <algorithm>
#include <utility>

namespace inkflate {
namespace {

void append(QuickShape const& shape, ShapePreview& preview) {
  int const first = preview.areas.empty() ? 0 : preview.areas.back() + 1;
  for (int const area : shape.areas) preview.areas.push_back(first + area);
  preview.contours.insert(preview.contours.end(), shape.contours.begin(), shape.contours.end());
  preview.closings.insert(preview.closings.end(), shape.closings.begin(), shape.closings.end());
}

}  // namespace

ShapePreview ShapePreviewer::preview(Document const& document, Progress const& progress) {
  std::vector<Known> next;
  for (auto& set : rough_sets(document)) {
    auto const& choice = set_choice(document, set);
    if (auto const* const known = find(set, choice, document)) {
      next.push_back(*known);
      continue;
    }
    auto const sketch = set_sketch(document, set);
    auto const shape = quick_shape(sketch, set_options(sketch, set, choice), progress);
    if (!shape && shape.error().code == ErrorCode::Cancelled) return {};
    next.push_back({std::move(set), choice, document.groups, shape ? *shape : QuickShape{}});
  }
  known_ = std::move(next);
  ShapePreview preview;
  for (auto const& known : known_) append(known.shape, preview);
  return preview;
}

ShapePreviewer::Known const* ShapePreviewer::find(RoughSet const& set, CloseChoice const& choice,
                                                  Document const& document) const {
  auto const found = std::find_if(known_.begin(), known_.end(), [&](Known const& known) {
    return known.set.layer == set.layer && known.set.depth == set.depth &&
           known.set.strokes == set.strokes && known.choice == choice &&
           known.groups == document.groups;
  });
  return found != known_.end() ? &*found : nullptr;
}

ShapePreview preview_shape(Document const& document, Progress const& progress) {
  return ShapePreviewer().preview(document, progress);
}

}  // namespace inkflate
