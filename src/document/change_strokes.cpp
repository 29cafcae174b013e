// SPDX-License-Identifier: Apache-2.0
#include "document/change_strokes.h"

#include <cstddef>
#include <iterator>
#include <utility>

namespace inkflate {
namespace {

/// Where what a stroke has become stands.
struct NewPlace {
  int first = 0;
  int count = 1;
  bool is_changed = false;
};

std::vector<NewPlace> new_places(int stroke_count, std::span<StrokeChange const> changes) {
  std::vector<NewPlace> places(static_cast<std::size_t>(stroke_count));
  for (auto const& change : changes) {
    auto& place = places[static_cast<std::size_t>(change.index)];
    place.count = static_cast<int>(std::ssize(change.pieces));
    place.is_changed = true;
  }
  int next = 0;
  for (auto& place : places) {
    place.first = next;
    next += place.count;
  }
  return places;
}

}  // namespace

StrokeList with_changes(StrokeList const& strokes, std::span<StrokeChange const> changes) {
  auto result = strokes;
  // From the end, so that the indices before stay right.
  for (std::size_t i = changes.size(); i > 0; --i) {
    result = result.with_replaced(changes[i - 1].index, changes[i - 1].pieces);
  }
  return result;
}

DocumentLayer with_changes(DocumentLayer const& layer, std::span<StrokeChange const> changes) {
  DocumentLayer result = {layer.layer, with_changes(layer.strokes, changes)};
  auto const places = new_places(layer.strokes.size(), changes);
  for (auto* list : {&result.layer.strokes, &result.layer.details, &result.layer.noise}) {
    std::vector<int> renumbered;
    for (int const stroke : *list) {
      auto const place = places[static_cast<std::size_t>(stroke)];
      for (int i = 0; i < place.count; ++i) renumbered.push_back(place.first + i);
    }
    *list = std::move(renumbered);
  }
  for (auto& outline : result.layer.outlines) {
    for (auto& source : outline.sources) {
      if (source.stroke < 0) continue;
      auto const place = places[static_cast<std::size_t>(source.stroke)];
      source.stroke = place.is_changed ? -1 : place.first;
    }
  }
  return result;
}

}  // namespace inkflate
