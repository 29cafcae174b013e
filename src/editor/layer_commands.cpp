// SPDX-License-Identifier: Apache-2.0
#include "editor/layer_commands.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "editor/pick.h"

namespace inkflate {
namespace {

// Far enough to see that there are two.
constexpr Vec2 kCopyOffsetPx = {20, 20};

Error nothing(char const* why) { return {ErrorCode::NothingThere, why}; }

bool is_among(std::vector<LayerId> const& layers, LayerId layer) {
  return std::find(layers.begin(), layers.end(), layer) != layers.end();
}

bool are_equal(StrokeList const& a, StrokeList const& b) {
  if (a.size() != b.size()) return false;
  for (int i = 0; i < a.size(); ++i) {
    if (a[i] != b[i] && a[i]->stroke.samples != b[i]->stroke.samples) return false;
  }
  return true;
}

/// Whether one would not be told from the other where they lie.
bool are_copies(DocumentLayer const& a, DocumentLayer const& b) {
  return a.layer.outlines == b.layer.outlines && a.layer.is_open == b.layer.is_open &&
         are_equal(a.strokes, b.strokes);
}

Result<Command> transformed(Document const& document, std::vector<LayerId> const& selection,
                            Affine const& map) {
  auto layers = pickable(document, selection);
  if (layers.empty()) return nothing("no part is selected that can be moved");
  if (map == Affine{}) return nothing("the parts would stay where they are");
  return Command{TransformLayers{std::move(layers), map}};
}

}  // namespace

std::vector<Command> duplicates(Document const& document, std::vector<LayerId> const& layers,
                                Vec2 offset) {
  std::vector<Command> commands;
  for (auto const& layer : *document.layers) {
    auto const id = layer->layer.id;
    if (is_among(layers, id)) commands.push_back(DuplicateLayer{id, OrderEnd::Front, offset});
  }
  return commands;
}

Result<std::vector<Command>> duplicate(Document const& document,
                                       std::vector<LayerId> const& selection) {
  auto commands = duplicates(document, selection, kCopyOffsetPx);
  if (commands.empty()) return nothing("no part is selected");
  return commands;
}

Result<std::vector<Command>> duplicate_or_remove(Document const& document, LayerId layer,
                                                 OrderEnd end) {
  auto const place = layer_index(document, layer);
  if (!place) return nothing("there is no such part");
  auto const& layers = *document.layers;
  int const count = static_cast<int>(std::ssize(layers));
  bool const is_back = end == OrderEnd::Back;
  int const first = is_back ? 0 : *place + 1;
  int const last = is_back ? *place : count;
  for (int i = first; i < last; ++i) {
    auto const& other = *layers[i];
    if (is_pickable(other) && are_copies(other, *layers[*place])) {
      return std::vector<Command>{DeleteLayers{{other.layer.id}}};
    }
  }
  return std::vector<Command>{DuplicateLayer{layer, end, {}}};
}

Result<Command> flip(Document const& document, std::vector<LayerId> const& selection,
                     FlipAxis axis) {
  auto const box = box_of(document, pickable(document, selection));
  if (box.is_empty()) return nothing("no part is selected that can be flipped");
  auto const twice = box.min + box.max;
  auto const map = axis == FlipAxis::Horizontal ? Affine{-1, 0, 0, 1, twice.x, 0}
                                                : Affine{1, 0, 0, -1, 0, twice.y};
  return transformed(document, selection, map);
}

Result<Command> nudge(Document const& document, std::vector<LayerId> const& selection,
                      Vec2 delta_px) {
  if (!is_finite(delta_px)) return Error{ErrorCode::BadInput, "parts cannot be moved that far"};
  return transformed(document, selection, Affine::translation(delta_px));
}

}  // namespace inkflate
