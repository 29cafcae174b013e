// SPDX-License-Identifier: Apache-2.0
#include "editor/bend_gesture.h"

#include <utility>

#include "document/apply.h"
#include "editor/bend_reach.h"
#include "editor/pins.h"
#include "editor/tools.h"

namespace inkflate {
namespace {

constexpr std::string_view kLabel = "deform";

BendOptions options_of(ToolSettings const& settings) {
  BendOptions options;
  options.mode = settings.bend_mode;
  options.body = settings.bend_body;
  return options;
}

/// False, and said: there is nothing to hold.
bool grab(EditorTurn& turn, BendGrab const& what) {
  auto& state = turn.state;
  auto const& document = state.history.document();
  auto const& settings = state.view.settings;
  auto const reach = bend_reach(document, what, bend_share(document, what, settings, state.bend));
  auto const error = state.bend.grab(document, what, reach, options_of(settings));
  if (error) say(turn, *error);
  return !error;
}

/// What has been bent so far becomes the gesture.
/// errors  of apply; NothingThere (nothing has moved)
std::optional<Error> take_bend(EditorTurn& turn) {
  auto& state = turn.state;
  auto commands = state.bend.commands();
  turn.changes.is_scene_changed = true;
  state.gesture.reset();
  if (commands.empty()) return Error{ErrorCode::NothingThere, "nothing has moved"};
  auto next = inkflate::apply(state.history.document(), commands);
  if (!next) return next.error();
  state.gesture = Gesture{std::move(commands), std::move(*next)};
  return std::nullopt;
}

/// Tells the session where the hand is, if it does not know.
void follow_hand(EditorState& state) {
  if (auto const hand = std::exchange(state.bend_hand, std::nullopt)) {
    state.bend.drag(hand->target, hand->turn_rad);
  }
}

}  // namespace

void bend_towards(EditorTurn& turn, ToolBending const& hand) {
  auto& state = turn.state;
  if (!state.bend.is_holding() && !grab(turn, hand.what)) {
    state.tool = ToolIdle{};
    return;
  }
  state.bend_hand = hand;
}

bool is_bend_waiting(EditorState const& state) {
  return state.bend.is_holding() && (state.bend_hand || !state.bend.is_settled());
}

void go_on_bending(EditorTurn& turn) {
  auto& state = turn.state;
  if (state.bend_hand) {
    follow_hand(state);
  } else {
    state.bend.settle();
  }
  take_bend(turn);
}

bool is_bend_unprepared(EditorState const& state) {
  auto const& view = state.view;
  return view.mode == Mode::Draw && view.tool == Tool::Deform && !state.bend.is_holding() &&
         !state.bend.is_prepared(state.history.document(), options_of(view.settings));
}

void prepare_bend(EditorState& state) {
  state.bend.prepare(state.history.document(), options_of(state.view.settings));
}

void finish_bend(EditorTurn& turn) {
  auto& state = turn.state;
  if (!state.bend.is_holding()) return;
  follow_hand(state);
  state.bend.finish();
  auto const error = take_bend(turn);
  if (error && error->code != ErrorCode::NothingThere) say(turn, *error);
  end_gesture(turn, kLabel);
  state.bend.release(error ? nullptr : &state.history.document());
}

void drop_bend(EditorState& state) {
  state.bend_hand.reset();
  if (state.bend.is_holding()) state.bend.release(nullptr);
}

void change_bend_reach(EditorTurn& turn, double factor) {
  auto& state = turn.state;
  auto& settings = state.view.settings;
  auto* const hand = std::get_if<ToolBending>(&state.tool);
  auto const& document = state.history.document();
  double const before = hand == nullptr ? settings.bend_reach.value_or(state.usual_reach)
                                        : bend_share(document, hand->what, settings, state.bend);
  double const share = bounded(before * factor, ToolSettings::kLeastBendReach, 1);
  settings.bend_reach = share;
  turn.changes.is_state_changed = turn.changes.is_scene_changed = true;
  if (hand == nullptr) return;
  auto const reach = bend_reach(document, hand->what, share);
  hand->ring_px = reach.px;
  state.bend.set_reach(reach);
  state.bend_hand = *hand;
}

void follow_reach(EditorTurn& turn) {
  auto& state = turn.state;
  bool const is_deforming = state.view.mode == Mode::Draw && state.view.tool == Tool::Deform;
  if (!is_deforming || is_bend_unprepared(state)) return;
  auto const& document = state.history.document();
  auto const* const hand = std::get_if<ToolBending>(&state.tool);
  auto const* const meant = meant_layer(document, state.view);
  auto const layer = hand != nullptr    ? hand->what.layer
                     : meant != nullptr ? meant->layer.id
                                        : LayerId::None;
  double const share = usual_share(document, layer, state.view.settings.bend_mode, state.bend);
  if (share == state.usual_reach) return;
  state.usual_reach = share;
  turn.changes.is_state_changed = true;
}

void bend_by_pin(EditorTurn& turn, Vec2 delta_px, std::optional<double> turn_rad) {
  auto& state = turn.state;
  auto const pin = *state.view.pin;
  auto const place = find_pin(state.history.document(), pin)->position;
  if (!grab(turn, {pin.layer, {}, pin.index, place})) return;
  state.bend.drag(place + delta_px, turn_rad);
  state.bend.finish();
  auto commands = state.bend.commands();
  bool const is_bent = !commands.empty() && commit(turn, std::move(commands), kLabel);
  state.bend.release(is_bent ? &state.history.document() : nullptr);
}

}  // namespace inkflate
