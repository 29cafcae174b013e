// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "editor/action_handlers.h"
#include "editor/layer_commands.h"
#include "editor/pick.h"
#include "io/numbers.h"

namespace inkflate {
namespace {

/// What is undone or redone is part of the drawing: there one sees it change.
void show_drawing(EditorTurn& turn) { turn.state.view.mode = Mode::Draw; }

void undo(EditorTurn& turn) {
  int const label = turn.state.history.undo_label();
  if (!undo_entry(turn)) return say(turn, Severity::Warning, Word::NothingToUndo);
  show_drawing(turn);
  say(turn, Severity::Status, Word::Undone, {std::string(action_name(label))});
}

void redo(EditorTurn& turn) {
  int const label = turn.state.history.redo_label();
  if (!redo_entry(turn)) return say(turn, Severity::Warning, Word::NothingToRedo);
  show_drawing(turn);
  say(turn, Severity::Status, Word::Redone, {std::string(action_name(label))});
}

/// What is deleted is the selected pin; the one before it is next.
void delete_pin(EditorTurn& turn, BendPinRef const& pin) {
  auto& view = turn.state.view;
  auto pins = find_layer(turn.state.history.document(), pin.layer)->layer.bend_pins;
  pins.erase(pins.begin() + pin.index);
  bool const is_last = pins.empty();
  if (!commit(turn, std::vector<Command>{SetBendPins{pin.layer, std::move(pins)}}, "delete")) {
    return;
  }
  // With the last one nothing is selected: who goes on pressing the key would delete the part.
  if (is_last) return set_selection(turn, {});
  view.pin = BendPinRef{pin.layer, std::max(pin.index - 1, 0)};
}

void delete_selected(EditorTurn& turn) {
  if (auto const pin = turn.state.view.pin) return delete_pin(turn, *pin);
  auto const& selection = turn.state.view.selection;
  if (selection.empty()) return say(turn, Severity::Warning, Word::NothingSelected);
  commit(turn, std::vector<Command>{DeleteLayers{selection}}, "delete");
}

void duplicate_selected(EditorTurn& turn) {
  auto& state = turn.state;
  auto const& before = state.history.document();
  auto const commands = duplicate(before, state.view.selection);
  int const first_id = before.next_id;
  if (!commit_if(turn, commands, "duplicate")) return;
  // The copies are what one goes on with.
  std::vector<LayerId> copies;
  for (int id = first_id; id < state.history.document().next_id; ++id)
    copies.push_back(LayerId{id});
  set_selection(turn, std::move(copies));
}

/// The layer that the argument names, or the only one that is selected.
LayerId named_layer(EditorTurn const& turn) {
  auto const& selection = turn.state.view.selection;
  if (auto const id = number_of(turn.argument)) {
    bool const is_id = *id >= 1 && *id < turn.state.history.document().next_id;
    return is_id ? static_cast<LayerId>(static_cast<int>(*id)) : LayerId::None;
  }
  return selection.size() == 1 ? selection[0] : LayerId::None;
}

void duplicate_at(EditorTurn& turn, OrderEnd end, std::string_view action) {
  auto const layer = named_layer(turn);
  if (layer == LayerId::None) return say(turn, Severity::Warning, Word::NothingSelected);
  auto const& history = turn.state.history;
  auto const count = history.document().layers->size();
  if (!commit_if(turn, duplicate_or_remove(history.document(), layer, end), action)) return;
  // The copy lies exactly on its original: without a word nothing seems to have happened.
  bool const is_made = history.document().layers->size() > count;
  auto const made = end == OrderEnd::Back ? Word::CopiedBehind : Word::CopiedBefore;
  say(turn, Severity::Status, is_made ? made : Word::CopyRemoved);
}

void select_all(EditorTurn& turn) {
  std::vector<LayerId> selection;
  for (auto const& layer : *turn.state.history.document().layers) {
    if (is_pickable(*layer)) selection.push_back(layer->layer.id);
  }
  set_selection(turn, std::move(selection));
}

/// The argument lists ids: "1 3 4"; an empty one selects nothing. Hidden layers and such as there are not are passed over.
void select(EditorTurn& turn) {
  std::vector<LayerId> selection;
  std::string_view rest = turn.argument;
  for (skip_separator(rest, Separator::Comma); !rest.empty();
       skip_separator(rest, Separator::Comma)) {
    auto const id = take_index(rest);
    if (!id) return refuse_argument(turn);
    selection.push_back(LayerId{*id});
  }
  set_selection(turn, std::move(selection));
}

/// A gesture is dropped by the engine before any action; then goes the pin, the selection, the tool.
void cancel(EditorTurn& turn) {
  auto& view = turn.state.view;
  if (view.pin) {
    view.pin.reset();
  } else if (!view.selection.empty()) {
    view.selection.clear();
  } else {
    view.tool = Tool::Brush;
  }
  turn.changes.is_scene_changed = turn.changes.is_state_changed = true;
}

bool can_undo(EditorState const& state) { return state.history.can_undo(); }
bool can_redo(EditorState const& state) { return state.history.can_redo(); }
bool has_layers(EditorState const& state) { return !state.history.document().layers->empty(); }
bool has_one_selected(EditorState const& state) { return state.view.selection.size() == 1; }

constexpr std::array kHandlers = {
    ActionHandler{"undo", undo, can_undo},
    ActionHandler{"redo", redo, can_redo},
    ActionHandler{"delete", delete_selected, has_pin_or_selection},
    ActionHandler{"duplicate", duplicate_selected, has_selection},
    ActionHandler{"duplicate_behind",
                  [](EditorTurn& turn) { duplicate_at(turn, OrderEnd::Back, "duplicate_behind"); },
                  has_one_selected},
    ActionHandler{"duplicate_before",
                  [](EditorTurn& turn) { duplicate_at(turn, OrderEnd::Front, "duplicate_before"); },
                  has_one_selected},
    ActionHandler{"select_all", select_all, has_layers},
    ActionHandler{"select", select, always},
    ActionHandler{"cancel", cancel, always},
};

}  // namespace

std::span<ActionHandler const> edit_handlers() { return kHandlers; }

}  // namespace inkflate
