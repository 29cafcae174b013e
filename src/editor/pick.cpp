// SPDX-License-Identifier: Apache-2.0
#include "editor/pick.h"

#include <algorithm>

#include "editor/layer_shape.h"

namespace inkflate {

bool is_pickable(DocumentLayer const& layer) {
  return !layer.layer.is_hidden && !layer.layer.is_locked;
}

bool is_under(DocumentLayer const& layer, Vec2 canvas, double reach_px) {
  if (contains(loose_box(layer.layer).grown(reach_px), canvas)) {
    auto const shape = layer_shape(layer.layer);
    if (contains(shape, canvas) || is_rim_near(shape, canvas, reach_px)) return true;
  }
  return layer.layer.is_open && !strokes_near(layer.strokes, canvas, canvas, reach_px).empty();
}

LayerId pick_layer(Document const& document, Vec2 canvas, double reach_px, PickDepth depth) {
  auto const& layers = *document.layers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    auto const& layer = *layers[depth == PickDepth::Farthest ? i : layers.size() - 1 - i];
    if (is_pickable(layer) && is_under(layer, canvas, reach_px)) return layer.layer.id;
  }
  return LayerId::None;
}

std::vector<LayerId> layers_in(Document const& document, Rect const& box) {
  std::vector<LayerId> found;
  for (auto const& layer : *document.layers) {
    if (is_pickable(*layer) && touch(layer_box(*layer), box)) found.push_back(layer->layer.id);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<LayerId> pickable(Document const& document, std::vector<LayerId> const& layers) {
  std::vector<LayerId> found;
  for (auto const& layer : *document.layers) {
    bool const is_asked = std::find(layers.begin(), layers.end(), layer->layer.id) != layers.end();
    if (is_asked && is_pickable(*layer)) found.push_back(layer->layer.id);
  }
  std::sort(found.begin(), found.end());
  return found;
}

Rect layer_box(DocumentLayer const& layer) {
  if (!layer.layer.outlines.empty()) return layer_shape(layer.layer).box;
  Rect box;
  layer.strokes.for_each([&](auto const& stroke) { box = united(box, stroke->box); });
  return box;
}

Rect box_of(Document const& document, std::vector<LayerId> const& layers) {
  Rect box;
  for (auto const& layer : *document.layers) {
    if (std::find(layers.begin(), layers.end(), layer->layer.id) == layers.end()) continue;
    box = united(box, layer_box(*layer));
  }
  return box;
}

Rect box_of(Document const& document) {
  Rect box;
  for (auto const& layer : *document.layers) {
    if (layer->layer.is_hidden) continue;
    box = united(box, layer_box(*layer));
    // Whiskers stick out.
    for (int const detail : layer->layer.details) box = united(box, layer->strokes[detail]->box);
    if (!layer->layer.is_open) continue;
    layer->strokes.for_each([&](auto const& stroke) { box = united(box, stroke->box); });
  }
  document.loose.for_each([&](auto const& stroke) { box = united(box, stroke->box); });
  return box;
}

}  // namespace inkflate
