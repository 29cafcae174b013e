// SPDX-License-Identifier: Apache-2.0
#include "editor/layer_looks.h"

namespace inkflate {
namespace {

bool looks_alike(DocumentLayer const& a, DocumentLayer const& b) {
  return a.strokes.is_same(b.strokes) && a.layer.is_open == b.layer.is_open &&
         a.layer.fill == b.layer.fill && a.layer.strokes == b.layer.strokes &&
         a.layer.details == b.layer.details && a.layer.outlines == b.layer.outlines;
}

}  // namespace

std::uint64_t LayerLooks::look(Shared<DocumentLayer> const& layer) {
  auto& entry = entries_[layer->layer.id];
  if (entry.layer == layer) return entry.look;
  if (!entry.layer || !looks_alike(*entry.layer, *layer)) entry.look = next_look_++;
  entry.layer = layer;
  return entry.look;
}

void LayerLooks::keep_only(Document const& document) {
  std::erase_if(entries_,
                [&](auto const& entry) { return find_layer(document, entry.first) == nullptr; });
}

}  // namespace inkflate
