// SPDX-License-Identifier: Apache-2.0
#include "support/editor_documents.h"

#include <memory>
#include <utility>

#include "support/sketches.h"

namespace inkflate {
namespace {

// Of a quarter of a circle: 4/3 tan(pi/8).
constexpr double kArc = 0.5522847498307936;

Document with_layers(Document document, std::vector<Shared<DocumentLayer>> layers) {
  document.layers = std::make_shared<std::vector<Shared<DocumentLayer>> const>(std::move(layers));
  return document;
}

}  // namespace

Outline circle_outline(Vec2 centre, double radius, Turn turn) {
  Outline outline;
  Vec2 from = {radius, 0};
  for (int i = 0; i < 4; ++i) {
    Vec2 const to = turn == Turn::Outer ? perpendicular(from) : -perpendicular(from);
    outline.pieces.push_back(
        {Cubic{{centre + from, centre + from + to * kArc, centre + to + from * kArc, centre + to}},
         RunKind::Ink});
    from = to;
  }
  outline.pieces.back().curve.control[3] = outline.pieces.front().curve.control[0];
  return outline;
}

Document with_loose(Document const& document, Stroke stroke) {
  auto next = document;
  next.loose = document.loose.with_pushed(keep(std::move(stroke)));
  return next;
}

Document with_layer(Document const& document, Layer layer, std::vector<Stroke> strokes) {
  layer.id = LayerId{document.next_id};
  DocumentLayer kept;
  for (auto& stroke : strokes) {
    layer.strokes.push_back(kept.strokes.size());
    kept.strokes = kept.strokes.with_pushed(keep(std::move(stroke)));
  }
  kept.layer = std::move(layer);
  auto layers = *document.layers;
  layers.push_back(std::make_shared<DocumentLayer const>(std::move(kept)));
  auto next = with_layers(document, std::move(layers));
  ++next.next_id;
  return next;
}

Document with_disc(Document const& document, Vec2 centre, double radius, std::string name) {
  Layer layer;
  layer.name = std::move(name);
  layer.outlines = {circle_outline(centre, radius)};
  return with_layer(document, std::move(layer), {circle_stroke(centre, radius)});
}

Document with_ring(Document const& document, Vec2 centre, double outer, double inner) {
  Layer layer;
  layer.name = "ring";
  layer.outlines = {circle_outline(centre, outer), circle_outline(centre, inner, Turn::Hole)};
  return with_layer(document, std::move(layer),
                    {circle_stroke(centre, outer), circle_stroke(centre, inner)});
}

Document with_open(Document const& document, std::vector<Stroke> strokes) {
  Layer layer;
  layer.name = "open";
  layer.is_open = true;
  return with_layer(document, std::move(layer), std::move(strokes));
}

Document with_changed(Document const& document, LayerId layer,
                      std::function<void(Layer&)> const& change) {
  auto layers = *document.layers;
  for (auto& kept : layers) {
    if (kept->layer.id != layer) continue;
    auto changed = *kept;
    change(changed.layer);
    kept = std::make_shared<DocumentLayer const>(std::move(changed));
  }
  return with_layers(document, std::move(layers));
}

std::vector<LayerId> layer_order(Document const& document) {
  std::vector<LayerId> ids;
  for (auto const& layer : *document.layers) ids.push_back(layer->layer.id);
  return ids;
}

}  // namespace inkflate
