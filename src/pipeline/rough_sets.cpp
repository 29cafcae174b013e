// SPDX-License-Identifier: Apache-2.0
#include "pipeline/rough_sets.h"

#include <algorithm>
#include <utility>

namespace inkflate {
namespace {

bool is_in_candidate(std::vector<StrokeGroup> const& groups, Stroke const& stroke) {
  return stroke.group >= 0 && is_candidate_layer(groups[stroke.group]);
}

}  // namespace

std::vector<RoughSet> rough_sets(Document const& document) {
  std::vector<RoughSet> sets;
  for (auto const& layer : *document.layers) {
    if (takes_strokes(layer->layer)) sets.push_back(layer_set(document, *layer));
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

RoughSet layer_set(Document const& document, DocumentLayer const& layer) {
  auto const all = layer.strokes.to_vector();
  auto const is_candidate = [&](Shared<KeptStroke> const& kept) {
    return is_in_candidate(*document.groups, kept->stroke);
  };
  bool const is_grouped = std::any_of(all.begin(), all.end(), is_candidate);
  RoughSet set = {layer.layer.id, StrokeDepth::Near, {}, {}};
  for (int i = 0; i < std::ssize(all); ++i) {
    if (is_grouped && all[i]->stroke.group >= 0 && !is_candidate(all[i])) continue;
    set.places.push_back(i);
    set.strokes.push_back(all[i]);
  }
  return set;
}

Sketch set_sketch(Document const& document, RoughSet const& set) {
  Sketch sketch = {document.width_px, document.height_px, *document.groups, {}};
  sketch.strokes.reserve(set.strokes.size());
  for (auto const& kept : set.strokes) sketch.strokes.push_back(kept->stroke);
  return sketch;
}

SimplifyOptions set_options(Sketch const& sketch, RoughSet const& set, CloseChoice const& choice) {
  bool const is_grouped =
      set.layer == LayerId::None &&
      std::any_of(sketch.strokes.begin(), sketch.strokes.end(),
                  [&](Stroke const& stroke) { return is_in_candidate(sketch.groups, stroke); });
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
