// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "document/apply.h"
#include "editor/action_handlers.h"
#include "editor/bend_gesture.h"
#include "editor/layer_commands.h"
#include "io/svg_colour.h"

namespace inkflate {
namespace {

constexpr int kFarNudgePx = 10;

/// The same change of every selected layer.
template <typename MakeCommand>
std::vector<Command> for_selection(EditorTurn const& turn, MakeCommand make_command) {
  std::vector<Command> commands;
  for (auto const id : turn.state.view.selection) commands.push_back(make_command(id));
  return commands;
}

/// False, and said, when nothing is selected.
bool is_something_selected(EditorTurn& turn) {
  if (has_selection(turn.state)) return true;
  say(turn, Severity::Warning, Word::NothingSelected);
  return false;
}

/// A value of every selected layer, as a slider sets it.
template <typename MakeCommand>
void set_value(EditorTurn& turn, std::string_view action, MakeCommand make_command) {
  if (!is_something_selected(turn)) return;
  auto const layers = turn.state.view.selection;
  auto const& base = slider_base(turn.state, action, layers);
  commit_value(turn, without_idle(base, for_selection(turn, make_command)), action, layers);
}

void rename(EditorTurn& turn) {
  set_value(turn, "rename_part", [&](LayerId id) { return RenameLayer{id, turn.argument}; });
}

void set_thickness(EditorTurn& turn) {
  auto const thickness = number_of(turn.argument);
  if (!thickness) return refuse_argument(turn);
  set_value(turn, "thickness", [&](LayerId id) { return SetThickness{id, *thickness}; });
}

/// "none" for the default of whoever draws it.
void set_fill(EditorTurn& turn) {
  auto const fill = turn.argument == "none" ? std::nullopt : parse_colour(turn.argument);
  if (!fill && turn.argument != "none") return refuse_argument(turn);
  set_value(turn, "fill", [&](LayerId id) { return SetFill{id, fill}; });
}

/// Turns a claim about the layer whose id the argument is round: rows of a list act on their own layer, and a hidden one cannot be
/// selected.
template <typename SetClaim>
void turn_round(EditorTurn& turn, std::string_view action, bool Layer::*claim) {
  auto const id = number_of(turn.argument);
  bool const is_id = id && *id >= 1 && *id <= DocumentLimits::kIds;
  auto const layer = is_id ? LayerId{static_cast<int>(*id)} : LayerId::None;
  auto const* const found = find_layer(turn.state.history.document(), layer);
  if (found == nullptr) return refuse_argument(turn);
  commit(turn, std::vector<Command>{SetClaim{layer, !(found->layer.*claim)}}, action);
}

/// Hides the selection; of a layer that is named, turns it round.
void hide(EditorTurn& turn) {
  if (!turn.argument.empty()) {
    return turn_round<SetHidden>(turn, "hide_part", &Layer::is_hidden);
  }
  if (!is_something_selected(turn)) return;
  commit(turn, for_selection(turn, [](LayerId id) { return SetHidden{id, true}; }), "hide_part");
}

/// Locks the selection, or frees it when all of it is locked; of a layer that is named, turns it round.
void lock(EditorTurn& turn) {
  if (!turn.argument.empty()) {
    return turn_round<SetLocked>(turn, "lock_part", &Layer::is_locked);
  }
  if (!is_something_selected(turn)) return;
  auto const& document = turn.state.history.document();
  auto const& selection = turn.state.view.selection;
  bool const is_any_free = std::any_of(selection.begin(), selection.end(), [&](LayerId id) {
    auto const* const layer = find_layer(document, id);
    return layer != nullptr && !layer->layer.is_locked;
  });
  auto const set_locked = [&](LayerId id) { return SetLocked{id, is_any_free}; };
  commit(turn, without_idle(document, for_selection(turn, set_locked)), "lock_part");
}

void move_to(EditorTurn& turn) {
  auto const index = number_of(turn.argument);
  if (!index) return refuse_argument(turn);
  auto const& selection = turn.state.view.selection;
  if (selection.size() != 1) return say(turn, Severity::Warning, Word::NothingSelected);
  int const place = static_cast<int>(std::clamp(*index, -1e6, 1e6));
  commit_if(turn, move_to_index(turn.state.history.document(), selection[0], place), "move_part");
}

template <DepthStep kStep>
void step(EditorTurn& turn) {
  constexpr std::array names = {"depth_farther", "depth_nearer", "depth_back", "depth_front"};
  if (!is_something_selected(turn)) return;
  commit_if(turn, step_depth(turn.state.history.document(), turn.state.view.selection, kStep),
            names[static_cast<std::size_t>(kStep)]);
}

template <FlipAxis kAxis>
void flip_selected(EditorTurn& turn) {
  if (!is_something_selected(turn)) return;
  commit_if(turn, flip(turn.state.history.document(), turn.state.view.selection, kAxis),
            kAxis == FlipAxis::Horizontal ? "flip_horizontal" : "flip_vertical");
}

template <int kRightPx, int kDownPx>
void nudge_selected(EditorTurn& turn) {
  if (has_pin(turn.state)) return bend_by_pin(turn, Vec2{kRightPx, kDownPx}, {});
  if (!is_something_selected(turn)) return;
  commit_if(
      turn,
      nudge(turn.state.history.document(), turn.state.view.selection, Vec2{kRightPx, kDownPx}),
      "select_tool");
}

constexpr std::array kHandlers = {
    ActionHandler{"rename_part", rename, has_selection},
    ActionHandler{"thickness", set_thickness, has_selection},
    ActionHandler{"fill", set_fill, has_selection},
    ActionHandler{"hide_part", hide, always},
    ActionHandler{"lock_part", lock, always},
    ActionHandler{"move_part", move_to, has_selection},
    ActionHandler{"depth_farther", step<DepthStep::Farther>, has_selection},
    ActionHandler{"depth_nearer", step<DepthStep::Nearer>, has_selection},
    ActionHandler{"depth_back", step<DepthStep::ToBack>, has_selection},
    ActionHandler{"depth_front", step<DepthStep::ToFront>, has_selection},
    ActionHandler{"flip_horizontal", flip_selected<FlipAxis::Horizontal>, has_selection},
    ActionHandler{"flip_vertical", flip_selected<FlipAxis::Vertical>, has_selection},
    ActionHandler{"nudge_left", nudge_selected<-1, 0>, has_pin_or_selection},
    ActionHandler{"nudge_right", nudge_selected<1, 0>, has_pin_or_selection},
    ActionHandler{"nudge_up", nudge_selected<0, -1>, has_pin_or_selection},
    ActionHandler{"nudge_down", nudge_selected<0, 1>, has_pin_or_selection},
    ActionHandler{"nudge_far_left", nudge_selected<-kFarNudgePx, 0>, has_pin_or_selection},
    ActionHandler{"nudge_far_right", nudge_selected<kFarNudgePx, 0>, has_pin_or_selection},
    ActionHandler{"nudge_far_up", nudge_selected<0, -kFarNudgePx>, has_pin_or_selection},
    ActionHandler{"nudge_far_down", nudge_selected<0, kFarNudgePx>, has_pin_or_selection},
};

}  // namespace

std::span<ActionHandler const> part_handlers() { return kHandlers; }

}  // namespace inkflate
