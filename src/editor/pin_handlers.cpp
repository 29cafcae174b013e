// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "editor/action_handlers.h"
#include "editor/bend_gesture.h"
#include "editor/pick.h"
#include "editor/pins.h"
#include "editor/turn_step.h"

namespace inkflate {
namespace {

Document const& document_of(EditorState const& state) { return state.history.document(); }

DocumentLayer const* pinned_layer(EditorState const& state) {
  return meant_layer(document_of(state), state.view);
}

/// Why no part is meant.
void ask_for_part(EditorTurn& turn) {
  auto const& view = turn.state.view;
  bool const are_several = pickable(document_of(turn.state), view.selection).size() > 1;
  say(turn, Severity::Warning, are_several ? Word::SeveralSelected : Word::NothingSelected);
}

/// Pins are seen and held with the Deform tool alone.
void select_pin(EditorTurn& turn, std::optional<BendPinRef> const& pin) {
  auto& view = turn.state.view;
  view.tool = Tool::Deform;
  view.mode = Mode::Draw;
  view.pin = pin;
  turn.changes.is_scene_changed = turn.changes.is_state_changed = true;
}

/// For who does not see which one it is.
void tell_pin(EditorTurn& turn) {
  auto const& view = turn.state.view;
  auto const pins = pins_in_turn(document_of(turn.state), view);
  auto const place = std::find(pins.begin(), pins.end(), *view.pin) - pins.begin() + 1;
  say(turn, Severity::Status, Word::PinSelected,
      {std::to_string(place) + "/" + std::to_string(pins.size())});
}

void go_to_pin(EditorTurn& turn, int step) {
  auto const& view = turn.state.view;
  auto const pins = pins_in_turn(document_of(turn.state), view);
  auto const pin = pin_after(pins, view.pin, step);
  if (!pin) return say(turn, Severity::Warning, Word::NoPin);
  select_pin(turn, pin);
  tell_pin(turn);
}

bool set_pins(EditorTurn& turn, LayerId layer, std::vector<BendPin> pins, std::string_view action) {
  return commit(turn, std::vector<Command>{SetBendPins{layer, std::move(pins)}}, action);
}

/// At a place "x,y", or where it holds best.
void add_pin(EditorTurn& turn) {
  auto place = place_of(turn.argument);
  if (!place && !turn.argument.empty()) return refuse_argument(turn);
  auto const* const layer = pinned_layer(turn.state);
  if (layer == nullptr) return ask_for_part(turn);
  if (!place) place = place_for_pin(layer->layer);
  if (!place) return say(turn, Severity::Warning, Word::NothingToBend);
  auto const id = layer->layer.id;
  auto pins = layer->layer.bend_pins;
  int const index = static_cast<int>(std::ssize(pins));
  pins.push_back({*place});
  if (!set_pins(turn, id, std::move(pins), "add_pin")) return;
  select_pin(turn, BendPinRef{id, index});
  // A hand that clicked there knows.
  if (turn.argument.empty()) tell_pin(turn);
}

void turn_pin(EditorTurn& turn, double turn_rad) {
  if (!turn.state.view.pin) return say(turn, Severity::Warning, Word::NoPin);
  bend_by_pin(turn, {}, turn_rad);
}

void free_pin(EditorTurn& turn) {
  auto const pin = turn.state.view.pin;
  if (!pin) return say(turn, Severity::Warning, Word::NoPin);
  auto pins = find_layer(document_of(turn.state), pin->layer)->layer.bend_pins;
  pins[static_cast<std::size_t>(pin->index)].turn_rad.reset();
  set_pins(turn, pin->layer, std::move(pins), "free_pin");
}

void delete_pins(EditorTurn& turn) {
  auto const* const layer = pinned_layer(turn.state);
  if (layer == nullptr) return ask_for_part(turn);
  set_pins(turn, layer->layer.id, {}, "delete_pins");
}

bool can_take_pin(EditorState const& state) { return pinned_layer(state) != nullptr; }
bool are_pins_there(EditorState const& state) {
  return !pins_in_turn(document_of(state), state.view).empty();
}
bool has_frozen_pin(EditorState const& state) {
  auto const* const pin = state.view.pin ? find_pin(document_of(state), *state.view.pin) : nullptr;
  return pin != nullptr && pin->turn_rad;
}
bool has_pins(EditorState const& state) {
  auto const* const layer = pinned_layer(state);
  return layer != nullptr && !layer->layer.bend_pins.empty();
}

constexpr std::array kHandlers = {
    ActionHandler{"add_pin", add_pin, can_take_pin},
    ActionHandler{"next_pin", [](EditorTurn& turn) { go_to_pin(turn, 1); }, are_pins_there},
    ActionHandler{"previous_pin", [](EditorTurn& turn) { go_to_pin(turn, -1); }, are_pins_there},
    ActionHandler{"turn_pin_left", [](EditorTurn& turn) { turn_pin(turn, -kTurnStepRad); },
                  has_pin},
    ActionHandler{"turn_pin_right", [](EditorTurn& turn) { turn_pin(turn, kTurnStepRad); },
                  has_pin},
    ActionHandler{"free_pin", free_pin, has_frozen_pin},
    ActionHandler{"delete_pins", delete_pins, has_pins},
};

}  // namespace

std::span<ActionHandler const> pin_handlers() { return kHandlers; }

}  // namespace inkflate
