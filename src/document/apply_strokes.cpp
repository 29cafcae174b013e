// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "document/apply.h"
#include "document/apply_one.h"
#include "document/change_strokes.h"
#include "document/check_values.h"
#include "document/cut_stroke.h"
#include "document/edit_layer.h"

namespace inkflate {
namespace {

using Limits = DocumentLimits;

Error too_many_strokes() {
  return {ErrorCode::TooLarge, "more than 1 000 000 strokes; erase some first"};
}

Error no_stroke(StrokeRef ref) {
  return {ErrorCode::BadInput,
          "there is no stroke " + std::to_string(ref.index) +
              (ref.layer == LayerId::None
                   ? std::string(" outside of the layers")
                   : " in layer " + std::to_string(static_cast<int>(ref.layer))) +
              ", or it is named twice",
          ref.index};
}

std::vector<StrokeChange> cuts(StrokeList const& strokes, Swept const& swept) {
  std::vector<StrokeChange> changes;
  int index = 0;
  strokes.for_each([&](Shared<KeptStroke> const& kept) {
    int const here = index++;
    if (!swept.may_meet(kept->box)) return;
    auto remains = swept.cut(kept->stroke);
    if (!remains) return;
    StrokeChange change = {here, {}};
    for (auto& piece : *remains) change.pieces.push_back(keep(std::move(piece)));
    changes.push_back(std::move(change));
  });
  return changes;
}

Fault eraser_fault(EraseArea const& command) {
  if (command.path.empty()) return Error{ErrorCode::NothingThere, "the eraser was nowhere"};
  if (std::ssize(command.path) > Limits::kSamplesOfStroke) {
    return Error{ErrorCode::TooLarge, "the eraser's way has more than 1 000 000 points"};
  }
  if (!(command.radius_px > 0 && command.radius_px <= Limits::kFarthestPx)) {
    return Error{ErrorCode::BadOption,
                 "the eraser's radius has to be above 0 and at most 1 000 000 px"};
  }
  if (!std::all_of(command.path.begin(), command.path.end(), is_on_sheet)) {
    return Error{ErrorCode::BadInput,
                 "a place of the eraser is no number or lies farther than 1 000 000 px away"};
  }
  return {};
}

}  // namespace

Result<Document> apply_one(Document const& document, AddStroke const& command) {
  if (command.stroke.samples.empty()) {
    return Error{ErrorCode::BadInput, "a stroke without any place"};
  }
  int const group_count = static_cast<int>(std::ssize(*document.groups));
  if (auto const fault = stroke_fault(command.stroke, group_count)) return *fault;
  if (stroke_count(document) >= Limits::kStrokes) return too_many_strokes();
  if (command.layer == LayerId::None) {
    auto result = document;
    result.loose = document.loose.with_pushed(keep(command.stroke));
    return result;
  }
  auto const place = open_layer_place(document, command.layer);
  if (!place) return place.error();
  auto layer = *(*document.layers)[*place];
  layer.layer.strokes.push_back(layer.strokes.size());
  layer.strokes = layer.strokes.with_pushed(keep(command.stroke));
  return with_layer(document, *place, std::move(layer));
}

Result<Document> apply_one(Document const& document, EraseArea const& command) {
  if (auto const fault = eraser_fault(command)) return *fault;
  Swept const swept(command.path, command.radius_px);
  auto result = document;
  bool is_met = false;
  if (auto const changes = cuts(document.loose, swept); !changes.empty()) {
    is_met = true;
    result.loose = with_changes(document.loose, changes);
  }
  for (std::size_t i = 0; i < document.layers->size(); ++i) {
    auto const& layer = *(*document.layers)[i];
    if (!takes_strokes(layer.layer)) continue;
    auto const changes = cuts(layer.strokes, swept);
    if (changes.empty()) continue;
    is_met = true;
    result = with_layer(result, i, with_changes(layer, changes));
  }
  if (!is_met) return Error{ErrorCode::NothingThere, "the eraser meets no stroke"};
  if (stroke_count(result) > Limits::kStrokes) return too_many_strokes();
  return result;
}

Result<Document> apply_one(Document const& document, EraseStrokes const& command) {
  if (command.strokes.empty()) return Error{ErrorCode::NothingThere, "no stroke is selected"};
  std::map<LayerId, std::vector<int>> chosen;
  for (auto const ref : command.strokes) chosen[ref.layer].push_back(ref.index);
  auto result = document;
  for (auto& [layer, indices] : chosen) {
    std::size_t place = 0;
    if (layer != LayerId::None) {
      auto const found = open_layer_place(document, layer);
      if (!found) return found.error();
      place = *found;
    }
    auto const& strokes =
        layer == LayerId::None ? document.loose : (*document.layers)[place]->strokes;
    std::sort(indices.begin(), indices.end());
    std::vector<StrokeChange> changes;
    for (int const index : indices) {
      bool const is_new = changes.empty() || changes.back().index != index;
      if (index < 0 || index >= strokes.size() || !is_new) return no_stroke({layer, index});
      changes.push_back({index, {}});
    }
    if (layer == LayerId::None) {
      result.loose = with_changes(strokes, changes);
    } else {
      result = with_layer(result, place, with_changes(*(*document.layers)[place], changes));
    }
  }
  return result;
}

}  // namespace inkflate
