// SPDX-License-Identifier: Apache-2.0
#include "pipeline/rough_sets.h"

#include <algorithm>
#include <utility>

namespace inkflate {

std::vector<RoughSet> rough_sets(Document const& document) {
  std::vector<RoughSet> sets;
  for (auto const& layer : *document.layers) {
    if (layer->layer.is_open) sets.push_back(layer_set(*layer));
  }
  RoughSet near = {LayerId::None, StrokeDepth::Near, {}, {}};
  RoughSet far = {LayerId::None, StrokeDepth::Far, {}, {}};
  int place = 0;
  document.loose.for_each([&](Shared<KeptStroke> const& kept) {
    auto& set = kept->stroke.depth == StrokeDepth::Far ? far : near;
    set.places.push_back(place++);
    set.strokes.push_back(kept);
  });
  sets.push_back(std::move(near));
  sets.push_back(std::move(far));
  std::erase_if(sets, [](RoughSet const& set) { return set.strokes.empty(); });
  return sets;
}

RoughSet layer_set(DocumentLayer const& layer) {
  RoughSet set = {layer.layer.id, StrokeDepth::Near, {}, layer.strokes.to_vector()};
  for (int i = 0; i < std::ssize(set.strokes); ++i) set.places.push_back(i);
  return set;
}

Sketch set_sketch(Document const& document, RoughSet const& set) {
  Sketch sketch = {document.width_px, document.height_px, *document.groups, {}};
  sketch.strokes.reserve(set.strokes.size());
  for (auto const& kept : set.strokes) sketch.strokes.push_back(kept->stroke);
  return sketch;
}

SimplifyOptions set_options(Sketch const& sketch, CloseChoice const& choice) {
  bool const is_grouped =
      std::any_of(sketch.strokes.begin(), sketch.strokes.end(), [&](Stroke const& stroke) {
        return stroke.group >= 0 && stroke.group < std::ssize(sketch.groups) &&
               is_candidate_layer(sketch.groups[stroke.group]);
      });
  SimplifyOptions options;
  options.gap_px = choice.gap_px;
  options.outside = choice.outside;
  options.inside = choice.inside;
  // Marks of the loose strokes are for the near and the far ones together, and stay when strokes are rubbed out.
  options.marks_beyond = MarksBeyond::PassOver;
  options.parts = is_grouped ? Parts::Groups : Parts::All;
  return options;
}

CloseChoice const& set_choice(Document const& document, RoughSet const& set) {
  auto const* const layer = find_layer(document, set.layer);
  return layer != nullptr ? layer->layer.choice : *document.choice;
}

}  // namespace inkflate
