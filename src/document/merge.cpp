// SPDX-License-Identifier: Apache-2.0
#include "document/merge.h"

#include <map>
#include <utility>

namespace inkflate {
namespace {

/// The stroke in the groups of another document, where its own come after `offset` others.
Shared<KeptStroke> regrouped(Shared<KeptStroke> const& kept, int offset) {
  if (kept->stroke.group < 0 || offset == 0) return kept;
  auto copy = *kept;
  copy.stroke.group += offset;
  return std::make_shared<KeptStroke const>(std::move(copy));
}

StrokeList regrouped(StrokeList const& list, int offset) {
  std::vector<Shared<KeptStroke>> strokes;
  strokes.reserve(static_cast<std::size_t>(list.size()));
  list.for_each(
      [&](Shared<KeptStroke> const& kept) { strokes.push_back(regrouped(kept, offset)); });
  return StrokeList::of(strokes);
}

template <typename T>
Shared<std::vector<T>> joined(std::vector<T> first, std::vector<T> const& second) {
  first.insert(first.end(), second.begin(), second.end());
  return std::make_shared<std::vector<T> const>(std::move(first));
}

}  // namespace

Document merged(Document const& lower, Document const& upper) {
  auto result = lower;
  int const offset = static_cast<int>(std::ssize(*lower.groups));
  result.groups = joined(*lower.groups, *upper.groups);
  regrouped(upper.loose, offset).for_each([&](Shared<KeptStroke> const& kept) {
    result.loose = result.loose.with_pushed(kept);
  });
  std::map<LayerId, LayerId> new_ids;
  std::vector<Shared<DocumentLayer>> layers;
  for (auto const& layer : *upper.layers) {
    auto copy = *layer;
    copy.layer.id = static_cast<LayerId>(result.next_id++);
    new_ids[layer->layer.id] = copy.layer.id;
    copy.strokes = regrouped(copy.strokes, offset);
    layers.push_back(std::make_shared<DocumentLayer const>(std::move(copy)));
  }
  result.layers = joined(*lower.layers, layers);
  std::vector<Pin> pins;
  for (auto pin : *upper.pins) {
    pin.id = static_cast<PinId>(result.next_id++);
    pin.layer = new_ids[pin.layer];
    pins.push_back(pin);
  }
  result.pins = joined(*lower.pins, pins);
  if (!result.template_picture) result.template_picture = upper.template_picture;
  return result;
}

}  // namespace inkflate
