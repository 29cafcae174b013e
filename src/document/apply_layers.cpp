// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "document/apply_one.h"
#include "document/check_values.h"
#include "document/edit_layer.h"
#include "document/edit_pins.h"

namespace inkflate {
namespace {

/// A copy of the document with one member of a layer set.
template <typename Value>
Result<Document> with_member(Document const& document, LayerId id, Reach reach,
                             Value Layer::*member, Value const& value) {
  auto const place = layer_place(document, id, reach);
  if (!place) return place.error();
  auto layer = *(*document.layers)[*place];
  if (layer.layer.*member == value) return no_change();
  layer.layer.*member = value;
  return with_layer(document, *place, std::move(layer));
}

}  // namespace

Result<Document> apply_one(Document const& document, OpenLayer const& command) {
  return with_member(document, command.layer, Reach::Unlocked, &Layer::is_open, true);
}

Result<Document> apply_one(Document const& document, RedrawLayer const& command) {
  auto const place = layer_place(document, command.layer, Reach::Unlocked);
  if (!place) return place.error();
  auto const& old = *(*document.layers)[*place];
  if (old.layer.is_open && old.strokes.is_empty()) return no_change();
  DocumentLayer empty = {old.layer, {}};
  empty.layer.is_open = true;
  for (auto* list : {&empty.layer.strokes, &empty.layer.details, &empty.layer.noise}) list->clear();
  for (auto& outline : empty.layer.outlines) {
    for (auto& source : outline.sources) source.stroke = -1;
  }
  return with_layer(document, *place, std::move(empty));
}

Result<Document> apply_one(Document const& document, CloseLayer const& command) {
  auto const place = open_layer_place(document, command.layer);
  if (!place) return place.error();
  if ((*document.layers)[*place]->layer.outlines.empty()) {
    return Error{ErrorCode::NothingThere, "the layer has no outline yet; simplify it first",
                 static_cast<int>(command.layer)};
  }
  return with_member(document, command.layer, Reach::Unlocked, &Layer::is_open, false);
}

Result<Document> apply_one(Document const& document, DeleteLayers const& command) {
  auto const chosen = unlocked_layers(document, command.layers);
  if (!chosen) return chosen.error();
  LayerList layers;
  for (auto const& layer : *document.layers) {
    if (chosen->count(layer->layer.id) == 0) layers.push_back(layer);
  }
  std::set<PinId> pins;
  for (auto const& pin : *document.pins) {
    if (chosen->count(pin.layer) > 0) pins.insert(pin.id);
  }
  return without_pins(with_layers(document, std::move(layers)), pins);
}

Result<Document> apply_one(Document const& document, SetLayerOrder const& command) {
  auto const& old = *document.layers;
  Error const wrong = {ErrorCode::BadInput, "an order has to name every layer once"};
  if (command.back_to_front.size() != old.size()) return wrong;
  std::set<LayerId> const named(command.back_to_front.begin(), command.back_to_front.end());
  if (named.size() != old.size()) return wrong;
  LayerList layers;
  for (auto const id : command.back_to_front) {
    auto const place = layer_place(document, id, Reach::Any);
    if (!place) return place.error();
    layers.push_back(old[*place]);
  }
  if (layers == old) return no_change();
  return with_layers(document, std::move(layers));
}

Result<Document> apply_one(Document const& document, RenameLayer const& command) {
  if (auto const fault = name_fault(command.name)) return *fault;
  return with_member(document, command.layer, Reach::Any, &Layer::name, command.name);
}

Result<Document> apply_one(Document const& document, SetThickness const& command) {
  if (auto const fault = thickness_fault(command.thickness)) return *fault;
  return with_member(document, command.layer, Reach::Unlocked, &Layer::thickness,
                     command.thickness);
}

Result<Document> apply_one(Document const& document, SetFill const& command) {
  return with_member(document, command.layer, Reach::Unlocked, &Layer::fill, command.fill);
}

Result<Document> apply_one(Document const& document, SetHidden const& command) {
  return with_member(document, command.layer, Reach::Any, &Layer::is_hidden, command.is_hidden);
}

Result<Document> apply_one(Document const& document, SetLocked const& command) {
  return with_member(document, command.layer, Reach::Any, &Layer::is_locked, command.is_locked);
}

Result<Document> apply_one(Document const& document, SetChoice const& command) {
  if (auto const fault = choice_fault(command.choice)) return *fault;
  if (command.layer != LayerId::None) {
    return with_member(document, command.layer, Reach::Unlocked, &Layer::choice, command.choice);
  }
  if (*document.choice == command.choice) return no_change();
  auto result = document;
  result.choice = std::make_shared<CloseChoice const>(command.choice);
  return result;
}

}  // namespace inkflate
