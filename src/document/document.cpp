// SPDX-License-Identifier: Apache-2.0
#include "document/document.h"

#include <iterator>
#include <utility>

#include "document/deal_strokes.h"

namespace inkflate {
namespace {

/// Adds the layer and its strokes to the drawing.
void append_layer(DocumentLayer const& from, Drawing& drawing) {
  auto& strokes = drawing.sketch.strokes;
  auto layer = from.layer;
  shift_strokes(layer, static_cast<int>(std::ssize(strokes)));
  drawing.layers.push_back(std::move(layer));
  from.strokes.for_each([&](auto const& kept) { strokes.push_back(kept->stroke); });
}

}  // namespace

Shared<KeptStroke> keep(Stroke stroke) {
  stroke.samples.shrink_to_fit();  // it stays as long as its document's history
  Rect box;
  for (auto const& sample : stroke.samples) box.include(sample.position);
  return std::make_shared<KeptStroke const>(KeptStroke{std::move(stroke), box});
}

Document empty_document() {
  Document document;
  document.groups = std::make_shared<std::vector<StrokeGroup> const>();
  document.choice = std::make_shared<CloseChoice const>();
  document.layers = std::make_shared<std::vector<Shared<DocumentLayer>> const>();
  document.pins = std::make_shared<std::vector<Pin> const>();
  document.clip = std::make_shared<Clip const>();
  return document;
}

Project to_project(Document const& document) {
  Project project;
  auto& drawing = project.drawing;
  drawing.sketch.width_px = document.width_px;
  drawing.sketch.height_px = document.height_px;
  drawing.sketch.groups = *document.groups;
  for (auto const& layer : *document.layers) append_layer(*layer, drawing);
  auto& strokes = drawing.sketch.strokes;
  document.loose.for_each([&](auto const& kept) {
    drawing.stray.push_back(static_cast<int>(std::ssize(strokes)));
    strokes.push_back(kept->stroke);
  });
  drawing.choice = *document.choice;
  if (document.template_picture) project.template_picture = *document.template_picture;
  project.pins = *document.pins;
  project.clip = *document.clip;
  project.next_id = document.next_id;
  return project;
}

Drawing shown_drawing(Document const& document) {
  Drawing drawing;
  drawing.sketch.width_px = document.width_px;
  drawing.sketch.height_px = document.height_px;
  drawing.sketch.groups = *document.groups;
  for (auto const& layer : *document.layers) {
    bool const is_shown = !layer->layer.is_hidden && !layer->layer.outlines.empty();
    if (is_shown) append_layer(*layer, drawing);
  }
  return drawing;
}

bool is_blank(Document const& document) {
  return document.loose.is_empty() && document.layers->empty() && document.pins->empty() &&
         document.template_picture == nullptr && document.clip->tracks.empty() &&
         *document.choice == CloseChoice{};
}

bool takes_strokes(Layer const& layer) {
  return layer.is_open && !layer.is_hidden && !layer.is_locked;
}

DocumentLayer const* find_layer(Document const& document, LayerId id) {
  auto const index = layer_index(document, id);
  return index ? (*document.layers)[static_cast<std::size_t>(*index)].get() : nullptr;
}

std::optional<int> layer_index(Document const& document, LayerId id) {
  auto const& layers = *document.layers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i]->layer.id == id) return static_cast<int>(i);
  }
  return {};
}

}  // namespace inkflate
