// SPDX-License-Identifier: Apache-2.0
#include "document/deal_strokes.h"

#include <cstddef>
#include <iterator>
#include <utility>

namespace inkflate {
namespace {

constexpr int kNobody = -1;

/// Where a stroke has gone.
struct Place {
  int layer = kNobody;
  int index = -1;  // in that layer's list
};

/// Leaves in the list what becomes the layer's here and now.
void claim(std::vector<int>& list, int layer, std::vector<Place>& places) {
  std::vector<int> own;
  for (int const stroke : list) {
    auto& place = places[static_cast<std::size_t>(stroke)];
    if (place.layer != kNobody) continue;
    place.layer = layer;
    own.push_back(stroke);
  }
  list = std::move(own);
}

void renumber(Layer& layer, int index, std::vector<Place> const& places) {
  for (auto* list : {&layer.strokes, &layer.details, &layer.noise}) {
    for (int& stroke : *list) stroke = places[static_cast<std::size_t>(stroke)].index;
  }
  for (auto& outline : layer.outlines) {
    for (auto& source : outline.sources) {
      if (source.stroke < 0) continue;
      auto const place = places[static_cast<std::size_t>(source.stroke)];
      source.stroke = place.layer == index ? place.index : -1;
    }
  }
}

}  // namespace

DealtStrokes deal_strokes(std::vector<Layer> layers, std::span<Shared<KeptStroke> const> strokes) {
  std::vector<Place> places(strokes.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    for (auto* list : {&layers[i].strokes, &layers[i].details, &layers[i].noise}) {
      claim(*list, static_cast<int>(i), places);
    }
  }
  DealtStrokes dealt;
  std::vector<std::vector<Shared<KeptStroke>>> own(layers.size());
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (places[i].layer == kNobody) {
      dealt.rest.push_back(static_cast<int>(i));
      continue;
    }
    auto& list = own[static_cast<std::size_t>(places[i].layer)];
    places[i].index = static_cast<int>(std::ssize(list));
    list.push_back(strokes[i]);
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    renumber(layers[i], static_cast<int>(i), places);
    dealt.layers.push_back({std::move(layers[i]), StrokeList::of(own[i])});
  }
  return dealt;
}

void shift_strokes(Layer& layer, int what) {
  for (auto* list : {&layer.strokes, &layer.details, &layer.noise}) {
    for (int& stroke : *list) stroke += what;
  }
  for (auto& outline : layer.outlines) {
    for (auto& source : outline.sources) source.stroke += source.stroke < 0 ? 0 : what;
  }
}

}  // namespace inkflate
