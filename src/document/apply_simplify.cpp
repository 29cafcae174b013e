// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "document/apply.h"
#include "document/apply_one.h"
#include "document/check_values.h"
#include "document/deal_strokes.h"
#include "document/edit_layer.h"

namespace inkflate {
namespace {

using Limits = DocumentLimits;

Error bad_input(std::string message, long long index = -1) {
  return {ErrorCode::BadInput, std::move(message), index};
}

/// What is wrong with a choice of loose strokes.
Fault choice_of_strokes_fault(std::vector<int> const& strokes, int stroke_count) {
  if (strokes.empty()) return Error{ErrorCode::NothingThere, "no stroke to simplify"};
  int before = -1;
  for (int const stroke : strokes) {
    if (stroke <= before || stroke >= stroke_count) {
      return bad_input("strokes to simplify that are not there or do not ascend", stroke);
    }
    before = stroke;
  }
  return {};
}

/// Which strokes of a list of this length a set takes; as claims, one for each stroke.
Result<std::vector<bool>> chosen_strokes(Simplify::Set const& set, int stroke_count) {
  std::vector<bool> is_chosen(static_cast<std::size_t>(stroke_count), set.layer != LayerId::None);
  if (set.layer != LayerId::None) {
    if (!set.strokes.empty()) return bad_input("a layer is simplified with all of its strokes");
    return is_chosen;
  }
  if (auto fault = choice_of_strokes_fault(set.strokes, stroke_count)) return *fault;
  for (int const stroke : set.strokes) is_chosen[static_cast<std::size_t>(stroke)] = true;
  return is_chosen;
}

/// The set's shapes with all of its strokes named; those that no shape names are noise of the first.
Result<std::vector<Layer>> complete_shapes(Simplify::Set const& set,
                                           std::vector<bool> const& is_chosen) {
  if (set.shapes.empty()) return Error{ErrorCode::NothingThere, "no shape comes of the strokes"};
  auto shapes = set.shapes;
  int const stroke_count = static_cast<int>(std::ssize(is_chosen));
  auto is_unnamed = is_chosen;
  for (auto const& shape : shapes) {
    if (shape.outlines.empty() || shape.outlines.front().pieces.empty()) {
      return bad_input("a shape without outline");
    }
    if (auto fault = layer_fault(shape, stroke_count)) return *fault;
    for (auto const* list : {&shape.strokes, &shape.details, &shape.noise}) {
      for (int const stroke : *list) {
        if (!is_chosen[static_cast<std::size_t>(stroke)]) {
          return bad_input("a shape takes a stroke that is not simplified", stroke);
        }
        is_unnamed[static_cast<std::size_t>(stroke)] = false;
      }
    }
  }
  for (int i = 0; i < stroke_count; ++i) {
    if (is_unnamed[static_cast<std::size_t>(i)]) shapes.front().noise.push_back(i);
  }
  return shapes;
}

/// Builds the document set by set. Sets speak of the document as it was before all of them.
class Simplifying {
 public:
  explicit Simplifying(Document const& document)
      : before_(document), layers_(*document.layers), next_id_(document.next_id) {}

  Fault add(Simplify::Set const& set) {
    return set.layer == LayerId::None ? add_loose(set) : add_layer(set);
  }

  Fault add(Simplify::Details const& details) {
    if (auto fault = choice_of_strokes_fault(details.strokes, before_.loose.size())) {
      return fault;
    }
    auto const place = layer_place(before_, details.layer, Reach::Unlocked);
    if (!place) return place.error();
    if ((*before_.layers)[*place]->layer.is_open) {
      return bad_input("details for a layer that is open", static_cast<int>(details.layer));
    }
    if (auto fault = take(details.strokes)) return fault;
    auto const here = place_now(details.layer);
    auto layer = **here;
    for (int const stroke : details.strokes) {
      layer.layer.details.push_back(layer.strokes.size());
      layer.strokes = layer.strokes.with_pushed(before_.loose[stroke]);
    }
    *here = std::make_shared<DocumentLayer const>(std::move(layer));
    return {};
  }

  Result<Document> finish() && {
    if (std::ssize(layers_) > Limits::kLayers) {
      return Error{ErrorCode::TooLarge, "more than 1024 layers; simplify fewer strokes at once"};
    }
    if (next_id_ > Limits::kIds) return no_more_ids();
    auto result = with_layers(before_, std::move(layers_));
    result.next_id = next_id_;
    if (taken_.empty()) return result;
    std::vector<Shared<KeptStroke>> rest;
    int index = 0;
    before_.loose.for_each([&](auto const& kept) {
      if (taken_.count(index++) == 0) rest.push_back(kept);
    });
    result.loose = StrokeList::of(rest);
    if (rest.empty()) {
      result.choice = std::make_shared<CloseChoice const>(CloseChoice{before_.choice->gap_px});
    }
    return result;
  }

 private:
  /// Loose strokes leave for a layer.
  Fault take(std::vector<int> const& strokes) {
    for (int const stroke : strokes) {
      if (!taken_.insert(stroke).second) return bad_input("a stroke is in two sets", stroke);
    }
    return {};
  }

  /// Where a layer of before is among those of now.
  LayerList::iterator place_now(LayerId id) {
    auto here = layers_.begin();
    while ((*here)->layer.id != id) ++here;
    return here;
  }

  /// Layers of their own, made of the shapes; closed, unlocked, each with a new id.
  Result<LayerList> made_layers(Simplify::Set const& set, StrokeList const& strokes) {
    auto is_chosen = chosen_strokes(set, strokes.size());
    if (!is_chosen) return is_chosen.error();
    auto shapes = complete_shapes(set, *is_chosen);
    if (!shapes) return shapes.error();
    auto dealt = deal_strokes(*shapes, strokes.to_vector());
    LayerList made;
    for (auto& layer : dealt.layers) {
      layer.layer.is_open = false;
      layer.layer.is_locked = false;
      layer.layer.bend_pins.clear();
      layer.layer.id = static_cast<LayerId>(next_id_++);
      made.push_back(std::make_shared<DocumentLayer const>(std::move(layer)));
    }
    return made;
  }

  Fault add_loose(Simplify::Set const& set) {
    auto const made = made_layers(set, before_.loose);
    if (!made) return made.error();
    if (auto fault = take(set.strokes)) return fault;
    auto const place = set.depth == StrokeDepth::Far ? layers_.begin() : layers_.end();
    layers_.insert(place, made->begin(), made->end());
    return {};
  }

  Fault add_layer(Simplify::Set const& set) {
    auto const place = open_layer_place(before_, set.layer);
    if (!place) return place.error();
    if (!simplified_.insert(set.layer).second) {
      return bad_input("a layer is in two sets", static_cast<int>(set.layer));
    }
    auto const& old = (*before_.layers)[*place];
    // The first keeps the old id, so none is given for it.
    --next_id_;
    auto made = made_layers(set, old->strokes);
    if (!made) return made.error();
    auto first = *made->front();
    first.layer.id = old->layer.id;
    first.layer.name = old->layer.name;
    first.layer.fill = old->layer.fill;
    first.layer.thickness = old->layer.thickness;
    first.layer.is_hidden = old->layer.is_hidden;
    made->front() = std::make_shared<DocumentLayer const>(std::move(first));
    auto const here = layers_.erase(place_now(set.layer));
    layers_.insert(here, made->begin(), made->end());
    return {};
  }

  Document const& before_;
  LayerList layers_;
  int next_id_ = 1;
  std::set<int> taken_;  // of the loose strokes
  std::set<LayerId> simplified_;
};

}  // namespace

Result<Document> apply_one(Document const& document, Simplify const& command) {
  if (command.sets.empty() && command.details.empty()) {
    return Error{ErrorCode::NothingThere, "nothing to simplify"};
  }
  Simplifying simplifying(document);
  for (auto const& set : command.sets) {
    if (auto const fault = simplifying.add(set)) return *fault;
  }
  for (auto const& details : command.details) {
    if (auto const fault = simplifying.add(details)) return *fault;
  }
  return std::move(simplifying).finish();
}

}  // namespace inkflate
