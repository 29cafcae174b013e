// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <utility>

#include "editor/layer_commands.h"
#include "editor/layer_shape.h"
#include "editor/pick.h"

namespace inkflate {
namespace {

/// A layer in the order that is being made.
struct Place {
  DocumentLayer const* layer = nullptr;
  LayerShape shape;
  bool is_selected = false;
};

/// Back to front.
std::vector<Place> places(Document const& document, std::vector<LayerId> const& selection) {
  std::vector<Place> order;
  for (auto const& layer : *document.layers) {
    bool const is_selected =
        std::find(selection.begin(), selection.end(), layer->layer.id) != selection.end();
    order.push_back({layer.get(), {}, is_selected});
  }
  return order;
}

/// The areas that decide what a step goes past. A layer without outlines is the box of its strokes.
void add_shapes(std::vector<Place>& order) {
  for (auto& place : order) {
    place.shape = layer_shape(place.layer->layer);
    if (!place.shape.contours.empty()) continue;
    auto const box = layer_box(*place.layer);
    if (box.is_empty()) continue;
    place.shape = {{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}, box};
  }
}

/// One step towards the end of the list. The foremost of the selected goes first, so that those behind find its new place; where
/// one has to go past another selected one, that is taken along.
void step_forward(std::vector<Place>& order) {
  int const count = static_cast<int>(std::ssize(order));
  for (int i = count - 1; i >= 0; --i) {
    if (!order[i].is_selected) continue;
    int target = i + 1;
    while (target < count &&
           (order[target].is_selected || !overlap(order[i].shape, order[target].shape))) {
      ++target;
    }
    if (target == count) continue;
    // Behind the target, the selected of this stretch keep their order.
    std::stable_partition(order.begin() + i, order.begin() + target + 1,
                          [](Place const& place) { return !place.is_selected; });
  }
}

void move_to_end(std::vector<Place>& order) {
  std::stable_partition(order.begin(), order.end(),
                        [](Place const& place) { return !place.is_selected; });
}

Result<Command> order_command(Document const& document, std::vector<LayerId> order) {
  auto const& layers = *document.layers;
  bool const is_same =
      std::equal(order.begin(), order.end(), layers.begin(), layers.end(),
                 [](LayerId id, auto const& layer) { return layer->layer.id == id; });
  if (is_same) return Error{ErrorCode::NothingThere, "the parts lie there already"};
  return Command{SetLayerOrder{std::move(order)}};
}

}  // namespace

Result<Command> step_depth(Document const& document, std::vector<LayerId> const& selection,
                           DepthStep step) {
  auto order = places(document, selection);
  bool const is_backward = step == DepthStep::Farther || step == DepthStep::ToBack;
  // Farther is nearer, looked at from behind.
  if (is_backward) std::reverse(order.begin(), order.end());
  if (step == DepthStep::ToBack || step == DepthStep::ToFront) {
    move_to_end(order);
  } else {
    add_shapes(order);
    step_forward(order);
  }
  if (is_backward) std::reverse(order.begin(), order.end());
  std::vector<LayerId> ids;
  for (auto const& place : order) ids.push_back(place.layer->layer.id);
  return order_command(document, std::move(ids));
}

Result<Command> move_to_index(Document const& document, LayerId layer, int index) {
  auto const from = layer_index(document, layer);
  if (!from) return Error{ErrorCode::NothingThere, "there is no such part"};
  std::vector<LayerId> ids;
  for (auto const& each : *document.layers) ids.push_back(each->layer.id);
  ids.erase(ids.begin() + *from);
  int const place = std::clamp(index, 0, static_cast<int>(std::ssize(ids)));
  ids.insert(ids.begin() + place, layer);
  return order_command(document, std::move(ids));
}

}  // namespace inkflate
