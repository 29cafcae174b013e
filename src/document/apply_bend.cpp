// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "document/apply_one.h"
#include "document/change_strokes.h"
#include "document/check_values.h"
#include "document/edit_layer.h"

namespace inkflate {
namespace {

Error bad_input(std::string message, long long index) {
  return {ErrorCode::BadInput, std::move(message), index};
}

/// What a member is from piece to piece or from source to source, each value once as long as it lasts.
template <typename Item, typename Value>
std::vector<Value> course(std::vector<Item> const& items, Value Item::*member) {
  std::vector<Value> values;
  for (auto const& item : items) {
    if (values.empty() || values.back() != item.*member) values.push_back(item.*member);
  }
  return values;
}

/// A bend may cut pieces and sources into more of them, but neither what they are nor the way the outline runs around changes. Which side
/// is inside is not asked: where an outline crosses itself its area, which is where it winds around at all, says nothing
/// of its sign. The first outline stays the outer one, all others stay holes.
bool is_same_course(Outline const& before, Outline const& after) {
  return course(before.pieces, &OutlinePiece::kind) == course(after.pieces, &OutlinePiece::kind) &&
         course(before.sources, &InkSource::stroke) == course(after.sources, &InkSource::stroke);
}

/// The stroke with other places; the same one where none of them is another. in: as many places as it has samples
Shared<KeptStroke> with_places(Shared<KeptStroke> const& kept, std::span<Vec2 const> places) {
  auto stroke = kept->stroke;
  bool is_moved = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    is_moved = is_moved || stroke.samples[i].position != places[i];
    stroke.samples[i].position = places[i];
  }
  return is_moved ? keep(std::move(stroke)) : kept;
}

bool are_on_sheet(std::span<Vec2 const> places) {
  for (auto const place : places) {
    if (!is_on_sheet(place)) return false;
  }
  return true;
}

Error off_sheet(long long index) {
  return bad_input("a bent line leaves the numbers or lies farther than 1 000 000 px away", index);
}

std::size_t sample_count(StrokeList const& strokes) {
  std::size_t count = 0;
  strokes.for_each([&](Shared<KeptStroke> const& kept) { count += kept->stroke.samples.size(); });
  return count;
}

StrokeList bent_strokes(StrokeList const& strokes, std::span<Vec2 const> places) {
  std::vector<StrokeChange> changes;
  int index = 0;
  strokes.for_each([&](Shared<KeptStroke> const& kept) {
    std::size_t const count = kept->stroke.samples.size();
    auto bent = with_places(kept, places.first(count));
    places = places.subspan(count);
    if (bent != kept) changes.push_back({index, {std::move(bent)}});
    ++index;
  });
  return changes.empty() ? strokes : with_changes(strokes, changes);
}

CloseChoice with_marks(CloseChoice choice, std::vector<Vec2> const& marks) {
  std::size_t next = 0;
  for (auto* list : {&choice.outside, &choice.inside}) {
    for (auto& mark : *list) mark = marks[next++];
  }
  return choice;
}

/// The layer in its new shape; the same one where nothing has moved.
Result<Shared<DocumentLayer>> bent_layer(Shared<DocumentLayer> const& layer,
                                         Bend::Part const& part) {
  auto const& old = layer->layer;
  auto const index = static_cast<long long>(part.layer);
  bool const fits = part.outlines.size() == old.outlines.size() &&
                    part.samples.size() == sample_count(layer->strokes) &&
                    part.marks.size() == old.choice.outside.size() + old.choice.inside.size();
  if (!fits) return bad_input("a bent layer has other outlines, samples or marks", index);
  for (std::size_t i = 0; i < part.outlines.size(); ++i) {
    if (is_same_course(old.outlines[i], part.outlines[i])) continue;
    return bad_input("a bent outline runs along other lines than before", index);
  }
  if (!are_on_sheet(part.samples)) return off_sheet(index);
  DocumentLayer bent = {old, bent_strokes(layer->strokes, part.samples)};
  bent.layer.outlines = part.outlines;
  bent.layer.choice = with_marks(std::move(bent.layer.choice), part.marks);
  if (auto fault = layer_fault(bent.layer, bent.strokes.size())) {
    fault->index = index;
    return *fault;
  }
  if (bent.layer == old && bent.strokes.is_same(layer->strokes)) return layer;
  return std::make_shared<DocumentLayer const>(std::move(bent));
}

/// Which of the lines lie in which list of strokes, in the order of the strokes.
using LinesOf = std::map<LayerId, std::map<int, std::vector<Vec2> const*>>;

Result<LinesOf> sorted_lines(Bend const& command) {
  std::set<LayerId> parts;
  for (auto const& part : command.parts) {
    if (!parts.insert(part.layer).second) {
      return bad_input("a layer is bent twice", static_cast<long long>(part.layer));
    }
  }
  LinesOf lines;
  for (auto const& [stroke, samples] : command.lines) {
    bool const is_new = lines[stroke.layer].emplace(stroke.index, &samples).second;
    if (!is_new || parts.count(stroke.layer) > 0) {
      return bad_input("a stroke is bent twice", stroke.index);
    }
  }
  return lines;
}

Result<std::vector<StrokeChange>> bent_lines(StrokeList const& strokes,
                                             std::map<int, std::vector<Vec2> const*> const& lines) {
  std::vector<StrokeChange> changes;
  for (auto const& [index, samples] : lines) {
    if (index < 0 || index >= strokes.size()) return bad_input("no such stroke to bend", index);
    auto const& kept = strokes[index];
    if (samples->size() != kept->stroke.samples.size()) {
      return bad_input("a bent stroke has more or fewer samples than before", index);
    }
    if (!are_on_sheet(*samples)) return off_sheet(index);
    auto bent = with_places(kept, *samples);
    if (bent != kept) changes.push_back({index, {std::move(bent)}});
  }
  return changes;
}

}  // namespace

Result<Document> apply_one(Document const& document, Bend const& command) {
  auto const lines = sorted_lines(command);
  if (!lines) return lines.error();
  auto layers = *document.layers;
  for (auto const& part : command.parts) {
    auto const place = layer_place(document, part.layer, Reach::Unlocked);
    if (!place) return place.error();
    auto bent = bent_layer(layers[*place], part);
    if (!bent) return bent.error();
    layers[*place] = *std::move(bent);
  }
  auto result = document;
  for (auto const& [id, strokes] : *lines) {
    auto const place =
        id == LayerId::None ? Result<std::size_t>(std::size_t{0}) : open_layer_place(document, id);
    if (!place) return place.error();
    auto const changes =
        bent_lines(id == LayerId::None ? document.loose : layers[*place]->strokes, strokes);
    if (!changes) return changes.error();
    if (changes->empty()) continue;
    if (id == LayerId::None) {
      result.loose = with_changes(document.loose, *changes);
    } else {
      layers[*place] =
          std::make_shared<DocumentLayer const>(with_changes(*layers[*place], *changes));
    }
  }
  if (layers == *document.layers && result.loose.is_same(document.loose)) return no_change();
  return with_layers(std::move(result), std::move(layers));
}

Result<Document> apply_one(Document const& document, SetBendPins const& command) {
  auto const place = layer_place(document, command.layer, Reach::Unlocked);
  if (!place) return place.error();
  if (auto fault = bend_pins_fault(command.pins)) {
    fault->index = static_cast<long long>(command.layer);
    return *fault;
  }
  auto layer = *(*document.layers)[*place];
  if (layer.layer.bend_pins == command.pins) return no_change();
  layer.layer.bend_pins = command.pins;
  return with_layer(document, *place, std::move(layer));
}

}  // namespace inkflate
