// SPDX-License-Identifier: Apache-2.0
#include "editor/pins.h"

#include <algorithm>
#include <limits>

#include "editor/layer_shape.h"
#include "editor/pick.h"

namespace inkflate {
namespace {

double squared_distance_to(std::vector<Vec2> const& held, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const place : held) least = std::min(least, squared_norm(place - p));
  return least;
}

/// The part that can only be meant. Null: there are several, or none.
DocumentLayer const* only_layer(Document const& document) {
  auto const& layers = *document.layers;
  auto const can_be = [](auto const& layer) { return is_pickable(*layer); };
  auto const first = std::find_if(layers.begin(), layers.end(), can_be);
  if (first == layers.end() || std::any_of(first + 1, layers.end(), can_be)) return nullptr;
  return first->get();
}

}  // namespace

BendPin const* find_pin(Document const& document, BendPinRef const& pin) {
  auto const* const layer = find_layer(document, pin.layer);
  if (layer == nullptr || !is_pickable(*layer)) return nullptr;
  auto const& pins = layer->layer.bend_pins;
  bool const is_there = pin.index >= 0 && pin.index < std::ssize(pins);
  return is_there ? &pins[static_cast<std::size_t>(pin.index)] : nullptr;
}

std::vector<BendPinRef> pins_of(Document const& document) {
  std::vector<BendPinRef> pins;
  auto const& layers = *document.layers;
  for (auto each = layers.rbegin(); each != layers.rend(); ++each) {
    if (!is_pickable(**each)) continue;
    auto const& layer = (*each)->layer;
    for (int i = 0; i < std::ssize(layer.bend_pins); ++i) pins.push_back({layer.id, i});
  }
  return pins;
}

std::vector<BendPinRef> pins_in_turn(Document const& document, View const& view) {
  auto const all = pins_of(document);
  std::vector<BendPinRef> pins;
  for (auto const& pin : all) {
    if (is_selected(view, pin.layer)) pins.push_back(pin);
  }
  return pins.empty() ? all : pins;
}

std::optional<BendPinRef> pin_after(std::vector<BendPinRef> const& pins,
                                    std::optional<BendPinRef> const& pin, int step) {
  if (pins.empty()) return std::nullopt;
  auto const found = pin ? std::find(pins.begin(), pins.end(), *pin) : pins.end();
  auto const count = std::ssize(pins);
  if (found == pins.end()) return step > 0 ? pins.front() : pins.back();
  return pins[static_cast<std::size_t>((found - pins.begin() + step + count) % count)];
}

DocumentLayer const* meant_layer(Document const& document, View const& view) {
  auto const layers = pickable(document, view.selection);
  if (layers.size() == 1) return find_layer(document, layers[0]);
  if (view.pin) return find_layer(document, view.pin->layer);
  return only_layer(document);
}

std::optional<Vec2> place_for_pin(Layer const& layer) {
  auto const shape = layer_shape(layer);
  if (shape.contours.empty()) return std::nullopt;
  std::vector<Vec2> held;
  for (auto const& pin : layer.bend_pins) held.push_back(pin.position);
  if (held.empty()) held.push_back(shape.box.centre());
  std::optional<Vec2> best;
  double farthest = -1;
  for (auto const p : shape.contours.front()) {
    double const size = squared_distance_to(held, p);
    if (size <= farthest) continue;
    farthest = size;
    best = p;
  }
  return best;
}

}  // namespace inkflate
