// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "document/apply.h"
#include "document/check_values.h"
#include "document/deal_strokes.h"
#include "document/document.h"

namespace inkflate {
namespace {

using Limits = DocumentLimits;

Error at(Error error, std::string const& kind, std::ptrdiff_t index) {
  error.message = kind + " " + std::to_string(index) + ": " + error.message;
  error.index = index;
  return error;
}

Fault size_fault(Project const& project) {
  auto const& drawing = project.drawing;
  bool const fits = std::ssize(drawing.sketch.strokes) <= Limits::kStrokes &&
                    std::ssize(drawing.layers) <= Limits::kLayers &&
                    std::ssize(project.pins) <= Limits::kPins;
  if (!fits) {
    return Error{ErrorCode::TooLarge, "more than 1 000 000 strokes, 1024 layers or 1024 pins"};
  }
  auto const is_new = [](Layer const& layer) { return layer.id == LayerId::None; };
  auto const new_ids = std::count_if(drawing.layers.begin(), drawing.layers.end(), is_new);
  if (project.next_id < 1 || project.next_id > Limits::kIds - new_ids) {
    return Error{ErrorCode::BadInput, "the next id is below 1 or above 2 000 000 000"};
  }
  auto const& sketch = drawing.sketch;
  bool const is_canvas = is_within(sketch.width_px, 0, Limits::kFarthestPx) &&
                         is_within(sketch.height_px, 0, Limits::kFarthestPx);
  if (!is_canvas) return Error{ErrorCode::BadInput, "the canvas is no number or too large"};
  return {};
}

Fault drawing_fault(Project const& project) {
  auto const& drawing = project.drawing;
  auto const& strokes = drawing.sketch.strokes;
  int const stroke_count = static_cast<int>(std::ssize(strokes));
  int const group_count = static_cast<int>(std::ssize(drawing.sketch.groups));
  for (int i = 0; i < stroke_count; ++i) {
    auto const fault = stroke_fault(strokes[static_cast<std::size_t>(i)], group_count);
    if (fault) return at(*fault, "stroke", i);
  }
  for (auto const& group : drawing.sketch.groups) {
    if (auto fault = thickness_fault(group.thickness)) return fault;
    if (!is_utf8(group.name)) return Error{ErrorCode::BadInput, "a group's name is not in UTF-8"};
  }
  std::set<LayerId> ids;
  for (std::ptrdiff_t i = 0; i < std::ssize(drawing.layers); ++i) {
    auto const& layer = drawing.layers[static_cast<std::size_t>(i)];
    if (auto const fault = layer_fault(layer, stroke_count)) return at(*fault, "layer", i);
    if (layer.id == LayerId::None) continue;
    bool const is_given = static_cast<int>(layer.id) > 0 &&
                          static_cast<int>(layer.id) < project.next_id &&
                          ids.insert(layer.id).second;
    if (!is_given) {
      return Error{ErrorCode::BadInput,
                   "layer " + std::to_string(i) + ": its id is another's or was never given", i};
    }
  }
  for (int const stray : drawing.stray) {
    if (stray < 0 || stray >= stroke_count) {
      return Error{ErrorCode::BadInput, "a loose stroke that there is not", stray};
    }
  }
  return choice_fault(drawing.choice);
}

Fault pins_fault(Project const& project) {
  std::set<LayerId> layers;
  for (auto const& layer : project.drawing.layers) layers.insert(layer.id);
  layers.erase(LayerId::None);
  std::set<PinId> pins;
  for (std::ptrdiff_t i = 0; i < std::ssize(project.pins); ++i) {
    auto const& pin = project.pins[static_cast<std::size_t>(i)];
    if (auto const fault = pin_fault(pin)) return at(*fault, "pin", i);
    bool const is_given = static_cast<int>(pin.id) > 0 &&
                          static_cast<int>(pin.id) < project.next_id && pins.insert(pin.id).second;
    if (!is_given || layers.count(pin.layer) == 0) {
      return Error{ErrorCode::BadInput,
                   "pin " + std::to_string(i) +
                       ": its id is another's or was never given, or its "
                       "layer is none",
                   i};
    }
  }
  if (auto fault = clip_length_fault(project.clip.length_s)) return fault;
  for (std::ptrdiff_t i = 0; i < std::ssize(project.clip.tracks); ++i) {
    auto const& track = project.clip.tracks[static_cast<std::size_t>(i)];
    if (auto const fault = track_fault(track, project.clip.length_s)) return at(*fault, "track", i);
    // Erased when found: a pin has one track at most.
    if (track.keys.empty() || pins.erase(track.pin) == 0) {
      return Error{ErrorCode::BadInput,
                   "track " + std::to_string(i) +
                       ": it has no keys, or its pin is none or moved "
                       "by another track",
                   i};
    }
  }
  return {};
}

}  // namespace

Result<Document> make_document(Project const& project) {
  if (auto const fault = size_fault(project)) return *fault;
  if (auto const fault = drawing_fault(project)) return *fault;
  if (auto const fault = pins_fault(project)) return *fault;
  auto const& drawing = project.drawing;
  Document document;
  document.width_px = drawing.sketch.width_px;
  document.height_px = drawing.sketch.height_px;
  document.next_id = project.next_id;
  std::vector<Shared<KeptStroke>> strokes;
  strokes.reserve(drawing.sketch.strokes.size());
  for (auto const& stroke : drawing.sketch.strokes) strokes.push_back(keep(stroke));
  auto dealt = deal_strokes(drawing.layers, strokes);
  std::vector<Shared<DocumentLayer>> layers;
  for (auto& layer : dealt.layers) {
    if (layer.layer.id == LayerId::None) {
      layer.layer.id = static_cast<LayerId>(document.next_id++);
    }
    layers.push_back(std::make_shared<DocumentLayer const>(std::move(layer)));
  }
  std::vector<Shared<KeptStroke>> loose;
  for (int const i : dealt.rest) loose.push_back(strokes[static_cast<std::size_t>(i)]);
  document.loose = StrokeList::of(loose);
  document.groups = std::make_shared<std::vector<StrokeGroup> const>(drawing.sketch.groups);
  document.choice = std::make_shared<CloseChoice const>(drawing.choice);
  document.layers = std::make_shared<std::vector<Shared<DocumentLayer>> const>(std::move(layers));
  if (project.template_picture) {
    document.template_picture = std::make_shared<Picture const>(*project.template_picture);
  }
  document.pins = std::make_shared<std::vector<Pin> const>(project.pins);
  document.clip = std::make_shared<Clip const>(project.clip);
  return document;
}

}  // namespace inkflate
