// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>
#include <utility>

#include "document/apply.h"
#include "document/apply_one.h"
#include "document/check_values.h"
#include "document/edit_layer.h"
#include "document/transform.h"

namespace inkflate {
namespace {

/// Nothing of the list has left the sheet.
Fault strokes_fault(StrokeList const& strokes, int group_count) {
  Fault fault;
  strokes.for_each([&](Shared<KeptStroke> const& kept) {
    if (!fault) fault = stroke_fault(kept->stroke, group_count);
  });
  return fault;
}

bool is_usable(Affine const& map) {
  for (double const value : {map.a, map.b, map.c, map.d, map.e, map.f}) {
    if (!std::isfinite(value)) return false;
  }
  // Not finite where the product of finite numbers is too large.
  return map.determinant() != 0 && std::isfinite(map.determinant());
}

Result<DocumentLayer> moved_layer(DocumentLayer const& layer, Affine const& map, int group_count) {
  DocumentLayer moved = {transformed(layer.layer, map), transformed(layer.strokes, map)};
  auto fault = strokes_fault(moved.strokes, group_count);
  if (!fault) fault = layer_fault(moved.layer, moved.strokes.size());
  if (!fault) return moved;
  fault->index = static_cast<int>(layer.layer.id);
  return *fault;
}

Result<Document> with_loose_moved(Document const& document, Affine const& map) {
  bool const has_marks = !document.choice->outside.empty() || !document.choice->inside.empty();
  if (document.loose.is_empty() && !has_marks) {
    return Error{ErrorCode::NothingThere, "no loose stroke to move"};
  }
  auto result = document;
  result.loose = transformed(document.loose, map);
  auto choice = transformed(*document.choice, map);
  int const group_count = static_cast<int>(std::ssize(*document.groups));
  if (auto const fault = strokes_fault(result.loose, group_count)) return *fault;
  if (auto const fault = choice_fault(choice)) return *fault;
  result.choice = std::make_shared<CloseChoice const>(std::move(choice));
  return result;
}

}  // namespace

Result<Document> apply_one(Document const& document, TransformLayers const& command) {
  auto const& map = command.map;
  if (!is_usable(map)) {
    return Error{ErrorCode::BadOption, "a map that is not finite or flattens all to a line"};
  }
  if (map == Affine{}) return no_change();
  if (command.layers.empty()) return with_loose_moved(document, map);
  auto const chosen = unlocked_layers(document, command.layers);
  if (!chosen) return chosen.error();
  auto layers = *document.layers;
  int const group_count = static_cast<int>(std::ssize(*document.groups));
  for (auto& layer : layers) {
    if (chosen->count(layer->layer.id) == 0) continue;
    auto moved = moved_layer(*layer, map, group_count);
    if (!moved) return moved.error();
    layer = std::make_shared<DocumentLayer const>(std::move(moved).value());
  }
  auto result = with_layers(document, std::move(layers));
  auto pins = *document.pins;
  for (auto& pin : pins) {
    if (chosen->count(pin.layer) == 0) continue;
    pin.rest = map(pin.rest);
    pin.position = map(pin.position);
    if (auto fault = pin_fault(pin)) {
      fault->index = static_cast<int>(pin.id);
      return *fault;
    }
  }
  if (pins != *document.pins) {
    result.pins = std::make_shared<std::vector<Pin> const>(std::move(pins));
  }
  return result;
}

Result<Document> apply_one(Document const& document, DuplicateLayer const& command) {
  auto const place = layer_place(document, command.layer, Reach::Any);
  if (!place) return place.error();
  auto copy = *(*document.layers)[*place];
  if (std::ssize(*document.layers) >= DocumentLimits::kLayers) {
    return Error{ErrorCode::TooLarge, "more than 1024 layers; delete some first"};
  }
  if (stroke_count(document) + copy.strokes.size() > DocumentLimits::kStrokes) {
    return Error{ErrorCode::TooLarge, "more than 1 000 000 strokes; erase some first"};
  }
  if (document.next_id >= DocumentLimits::kIds) return no_more_ids();
  if (!is_on_sheet(command.offset)) {
    return Error{ErrorCode::BadOption, "the offset is no number or more than 1 000 000 px"};
  }
  if (command.offset != Vec2{}) {
    auto moved = moved_layer(copy, Affine::translation(command.offset),
                             static_cast<int>(std::ssize(*document.groups)));
    if (!moved) return moved.error();
    copy = std::move(moved).value();
  }
  copy.layer.name += " copy";
  copy.layer.id = static_cast<LayerId>(document.next_id);
  copy.layer.is_locked = false;  // it was just made to be worked on
  auto layers = *document.layers;
  auto const end = command.end == OrderEnd::Back ? layers.begin() : layers.end();
  layers.insert(end, std::make_shared<DocumentLayer const>(std::move(copy)));
  auto result = with_layers(document, std::move(layers));
  ++result.next_id;
  return result;
}

}  // namespace inkflate
