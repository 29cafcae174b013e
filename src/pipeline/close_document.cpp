// SPDX-License-Identifier: Apache-2.0
#include "pipeline/close_document.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "pipeline/lay_details.h"
#include "pipeline/rough_sets.h"
#include "simplify/widest_opening.h"

namespace inkflate {
namespace {

/// Gives new parts names that no other part has.
class PartNames {
 public:
  explicit PartNames(Document const& document) {
    for (auto const& layer : *document.layers) taken_.insert(layer->layer.name);
  }

  /// The name itself, or, where it only counts parts and is taken, the next one that is not.
  std::string fresh(std::string name) {
    if (is_number_of_part(name)) {
      for (int n = 1; taken_.count(name) > 0; ++n) name = kPart + std::to_string(n);
    }
    taken_.insert(name);
    return name;
  }

 private:
  // As simplify names what is drawn in no group.
  static constexpr char const* kPart = "part ";

  static bool is_number_of_part(std::string const& name) {
    std::string const part = kPart;
    return name.size() > part.size() && name.compare(0, part.size(), part) == 0 &&
           std::all_of(name.begin() + static_cast<std::ptrdiff_t>(part.size()), name.end(),
                       [](char c) { return c >= '0' && c <= '9'; });
  }

  std::set<std::string> taken_;
};

/// Turns indices into the set's strokes to places in the list that the strokes are in.
void move_to_places(std::vector<int> const& places, Layer& layer) {
  for (auto* const strokes : {&layer.strokes, &layer.details, &layer.noise}) {
    for (int& stroke : *strokes) stroke = places[stroke];
  }
  for (auto& outline : layer.outlines) {
    for (auto& source : outline.sources) source.stroke = places[source.stroke];
  }
}

/// The outer outlines of the other parts that are seen: what a limb can be open towards.
std::vector<Outline> hosts_of(Document const& document, RoughSet const& set) {
  std::vector<Outline> hosts;
  for (auto const& layer : *document.layers) {
    auto const& data = layer->layer;
    bool const is_host = data.id != set.layer && !data.is_hidden && !data.outlines.empty();
    if (is_host) hosts.push_back(data.outlines.front());
  }
  return hosts;
}

/// What simplify makes of a set, as a command has it.
Result<Simplify::Set> close_set(Document const& document, RoughSet const& set,
                                CloseChoice const& choice, PartNames& names,
                                Progress const& progress) {
  auto const sketch = set_sketch(document, set);
  auto options = set_options(sketch, set, choice);
  options.hosts = hosts_of(document, set);
  auto drawing = simplify(sketch, options, progress);
  if (!drawing) return drawing.error();
  Simplify::Set result = {set.layer, {}, set.depth, std::move(drawing->layers)};
  if (set.layer == LayerId::None) result.strokes = set.places;
  auto const* const known = find_layer(document, set.layer);
  for (auto& shape : result.shapes) {
    bool const keeps_name = known != nullptr && &shape == result.shapes.data();
    shape.name = keeps_name ? known->layer.name : names.fresh(std::move(shape.name));
    shape.choice = choice;
    move_to_places(set.places, shape);
  }
  return result;
}

ClosingFault fault_of(Document const& document, RoughSet const& set, Error error) {
  return {set.layer, set.depth, std::move(error), widest_opening(set_sketch(document, set))};
}

int count_closings(std::vector<Layer> const& shapes) {
  constexpr double coarse_px = 10;  // only the kinds count
  int count = 0;
  for (auto const& shape : shapes) {
    for (auto const& outline : shape.outlines) {
      for (auto const& run : runs(outline, coarse_px))
        count += run.kind == RunKind::Closing ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

Result<ClosedDocument> close_document(Document const& document, Progress const& progress) {
  auto const sets = rough_sets(document);
  if (sets.empty()) {
    return Error{ErrorCode::NothingThere, "there are no strokes to close: draw a shape first"};
  }
  PartNames names(document);
  ClosedDocument result;
  Simplify command;
  for (auto set : sets) {
    auto closed = close_set(document, set, set_choice(document, set), names, progress);
    if (!closed && closed.error().code == ErrorCode::Cancelled) return closed.error();
    if (closed) {
      result.details += lay_details(document, set, *closed, command.details);
      result.closings += count_closings(closed->shapes);
      command.sets.push_back(*std::move(closed));
      continue;
    }
    if (closed.error().code == ErrorCode::NothingThere) {
      result.details += lay_details(document, set, command.details);
    }
    if (!set.places.empty()) result.faults.push_back(fault_of(document, set, closed.error()));
  }
  if (!command.sets.empty() || !command.details.empty()) result.command = std::move(command);
  return result;
}

Result<Simplify> close_layer_again(Document const& document, LayerId layer,
                                   CloseChoice const& choice, Progress const& progress) {
  auto const* const known = find_layer(document, layer);
  if (known == nullptr || known->strokes.is_empty()) {
    return Error{ErrorCode::NothingThere, "the layer has no strokes to close: draw it again"};
  }
  PartNames names(document);
  auto closed = close_set(document, layer_set(document, *known), choice, names, progress);
  if (!closed) return closed.error();
  return Simplify{{*std::move(closed)}};
}

}  // namespace inkflate
