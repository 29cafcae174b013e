// SPDX-License-Identifier: Apache-2.0
#include "document/edit_layer.h"

#include <memory>
#include <string>
#include <utility>

namespace inkflate {
namespace {

Error refused(LayerId id, std::string message) {
  return {ErrorCode::BadInput, std::move(message), static_cast<int>(id)};
}

std::string in_quotes(std::string const& name) { return "\"" + name + "\""; }

}  // namespace

Result<std::size_t> layer_place(Document const& document, LayerId id, Reach reach) {
  auto const index = layer_index(document, id);
  if (!index) return refused(id, "there is no layer " + std::to_string(static_cast<int>(id)));
  auto const place = static_cast<std::size_t>(*index);
  auto const& layer = (*document.layers)[place]->layer;
  if (reach == Reach::Unlocked && layer.is_locked) {
    return refused(id, "layer " + in_quotes(layer.name) + " is locked; unlock it first");
  }
  return place;
}

Result<std::size_t> open_layer_place(Document const& document, LayerId id) {
  auto place = layer_place(document, id, Reach::Unlocked);
  if (!place) return place;
  auto const& layer = (*document.layers)[*place]->layer;
  if (layer.is_open) return place;
  return refused(id, "layer " + in_quotes(layer.name) + " is closed; open it to draw it again");
}

Result<std::set<LayerId>> unlocked_layers(Document const& document,
                                          std::span<LayerId const> layers) {
  if (layers.empty()) return Error{ErrorCode::NothingThere, "no layer is selected"};
  std::set<LayerId> chosen;
  for (auto const id : layers) {
    auto const place = layer_place(document, id, Reach::Unlocked);
    if (!place) return place.error();
    if (!chosen.insert(id).second) {
      return refused(id, "layer " + std::to_string(static_cast<int>(id)) + " is named twice");
    }
  }
  return chosen;
}

Document with_layers(Document document, LayerList layers) {
  document.layers = std::make_shared<LayerList const>(std::move(layers));
  return document;
}

Document with_layer(Document const& document, std::size_t place, DocumentLayer layer) {
  auto layers = *document.layers;
  layers[place] = std::make_shared<DocumentLayer const>(std::move(layer));
  return with_layers(document, std::move(layers));
}

int stroke_count(Document const& document) {
  int count = document.loose.size();
  for (auto const& layer : *document.layers) count += layer->strokes.size();
  return count;
}

Error no_change() { return {ErrorCode::NothingThere, "that would change nothing"}; }

Error no_more_ids() {
  return {ErrorCode::TooLarge, "more than 2 000 000 000 layers and pins were made; begin anew"};
}

}  // namespace inkflate
