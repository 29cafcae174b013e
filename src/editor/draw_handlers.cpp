// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "editor/action_handlers.h"
#include "editor/pick.h"

namespace inkflate {
namespace {

/// A click this near to a mark takes the mark away, screen px.
constexpr double kMarkReachPx = 10;

void say_faults(EditorTurn& turn, std::vector<ClosingFault> const& faults) {
  for (auto const& fault : faults) {
    Rect place;
    place.include(fault.place);
    if (fault.error.code == ErrorCode::NothingThere) {
      say(turn, Severity::Problem, Word::NotClosed, {}, place);
    } else {
      say(turn, Severity::Problem, Word::CannotDo, {fault.error.message}, place);
    }
  }
}

void say_closed(EditorTurn& turn, int closings) {
  if (closings == 0) return say(turn, Severity::Status, Word::ClosedNoGap);
  say(turn, Severity::Status, Word::ClosedGaps, {std::to_string(closings)});
}

/// Layers that are being drawn again.
std::vector<LayerId> open_layers(Document const& document) {
  std::vector<LayerId> result;
  for (auto const& layer : *document.layers) {
    if (takes_strokes(layer->layer)) result.push_back(layer->layer.id);
  }
  return result;
}

CloseChoice const& choice_of(Document const& document, LayerId layer) {
  auto const* const found = find_layer(document, layer);
  return found == nullptr ? *document.choice : found->layer.choice;
}

/// What gives closed layers another choice and closes them anew. Nothing, and said, when one cannot be closed.
std::optional<std::vector<Command>> closed_again(EditorTurn& turn, Document const& document,
                                                 std::vector<LayerId> const& layers,
                                                 CloseChoice (*change)(CloseChoice,
                                                                       EditorTurn const&)) {
  std::vector<Command> commands;
  for (auto const id : layers) {
    auto closed =
        close_layer_again(document, id, change(choice_of(document, id), turn), turn.progress);
    if (!closed) {
      say(turn, closed.error());
      return std::nullopt;
    }
    commands.emplace_back(OpenLayer{id});
    commands.emplace_back(std::move(*closed));
  }
  return commands;
}

/// "auto", or the largest gap in px.
bool is_gap(std::string const& argument) {
  return argument == "auto" || number_of(argument).value_or(0) > 0;
}

CloseChoice with_gap(CloseChoice choice, EditorTurn const& turn) {
  choice.gap_px = number_of(turn.argument);
  return choice;
}

/// The gap of the selection, which is closed already.
void close_with_gap(EditorTurn& turn) {
  auto const layers = turn.state.view.selection;
  auto commands = closed_again(turn, slider_base(turn.state, "gap", layers), layers, with_gap);
  if (commands) commit_value(turn, *std::move(commands), "gap", layers);
}

/// Of what is rough; of the selection when nothing is.
void gap(EditorTurn& turn) {
  if (!is_gap(turn.argument)) return refuse_argument(turn);
  auto const& document = turn.state.history.document();
  auto targets = open_layers(document);
  bool const is_all_closed = targets.empty() && document.loose.is_empty();
  if (is_all_closed && has_selection(turn.state)) return close_with_gap(turn);
  targets.push_back(LayerId::None);
  auto const& base = slider_base(turn.state, "gap", targets);
  std::vector<Command> commands;
  for (auto const id : targets) {
    commands.emplace_back(SetChoice{id, with_gap(choice_of(base, id), turn)});
  }
  commit_value(turn, without_idle(base, commands), "gap", targets);
}

/// Puts a mark there, or takes away the one that is.
void toggle_mark(std::vector<Vec2>& marks, Vec2 place, double reach_px) {
  auto const is_near = [&](Vec2 mark) { return distance(mark, place) <= reach_px; };
  auto const found = std::find_if(marks.begin(), marks.end(), is_near);
  if (found != marks.end()) {
    marks.erase(found);
  } else {
    marks.push_back(place);
  }
}

CloseChoice with_mark(CloseChoice choice, EditorTurn const& turn,
                      std::vector<Vec2> CloseChoice::*marks) {
  auto const place = place_of(turn.argument);
  toggle_mark(choice.*marks, *place, kMarkReachPx / turn.state.view.camera.zoom);
  return choice;
}
CloseChoice with_outside(CloseChoice choice, EditorTurn const& turn) {
  return with_mark(std::move(choice), turn, &CloseChoice::outside);
}
CloseChoice with_inside(CloseChoice choice, EditorTurn const& turn) {
  return with_mark(std::move(choice), turn, &CloseChoice::inside);
}

/// Whose shape a mark at a place means: the nearest closed layer around it, also around a hole or bay of its.
LayerId marked_layer(Document const& document, Vec2 place) {
  auto const& layers = *document.layers;
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    auto const& data = (*layer)->layer;
    if (data.is_hidden || data.is_locked || data.is_open) continue;
    auto const box = layer_box(**layer);
    if (contains(box, place)) return data.id;
  }
  return LayerId::None;
}

/// Loose strokes and open layers come first: they are what one works on.
void mark(EditorTurn& turn, std::string_view action,
          CloseChoice (*change)(CloseChoice, EditorTurn const&)) {
  auto const place = place_of(turn.argument);
  if (!place) return refuse_argument(turn);
  auto const& document = turn.state.history.document();
  auto const open = open_layers(document);
  if (!document.loose.is_empty() || !open.empty()) {
    auto const target = open.empty() ? LayerId::None : open.back();
    commit(turn, std::vector<Command>{SetChoice{target, change(choice_of(document, target), turn)}},
           action);
    return;
  }
  auto const layer = marked_layer(document, *place);
  if (layer == LayerId::None) return say(turn, Severity::Warning, Word::NothingRough);
  auto commands = closed_again(turn, document, {layer}, change);
  if (commands) commit(turn, *std::move(commands), action);
}

template <typename LayerCommand>
void for_each_selected(EditorTurn& turn, std::string_view action) {
  auto const& selection = turn.state.view.selection;
  if (selection.empty()) return say(turn, Severity::Warning, Word::NothingSelected);
  std::vector<Command> commands;
  for (auto const id : selection) commands.emplace_back(LayerCommand{id});
  commit(turn, without_idle(turn.state.history.document(), commands), action);
}

bool is_rough(EditorState const& state) { return has_rough_strokes(state.history.document()); }

constexpr std::array kHandlers = {
    ActionHandler{"simplify", simplify_document, is_rough},
    ActionHandler{"gap", gap,
                  [](EditorState const& state) { return is_rough(state) || has_selection(state); }},
    ActionHandler{"mark_outside",
                  [](EditorTurn& turn) { mark(turn, "mark_outside", with_outside); }, always},
    ActionHandler{"mark_inside", [](EditorTurn& turn) { mark(turn, "mark_inside", with_inside); },
                  always},
    ActionHandler{"open_part",
                  [](EditorTurn& turn) { for_each_selected<OpenLayer>(turn, "open_part"); },
                  has_selection},
    ActionHandler{"redraw_part",
                  [](EditorTurn& turn) { for_each_selected<RedrawLayer>(turn, "redraw_part"); },
                  has_selection},
    ActionHandler{"close_part",
                  [](EditorTurn& turn) { for_each_selected<CloseLayer>(turn, "close_part"); },
                  has_selection},
};

}  // namespace

std::span<ActionHandler const> draw_handlers() { return kHandlers; }

void simplify_document(EditorTurn& turn) {
  auto closed = close_document(turn.state.history.document(), turn.progress);
  if (!closed) {
    if (closed.error().code != ErrorCode::NothingThere) return say(turn, closed.error());
    return say(turn, Severity::Warning, Word::NothingRough);
  }
  if (closed->command) {
    bool const is_closing = !closed->command->sets.empty();
    bool const is_done =
        commit(turn, std::vector<Command>{std::move(*closed->command)}, "simplify");
    if (is_done && is_closing) say_closed(turn, closed->closings);
    if (is_done && closed->details > 0) {
      say(turn, Severity::Status, Word::LaidOnParts, {std::to_string(closed->details)});
    }
  }
  say_faults(turn, closed->faults);
}

}  // namespace inkflate
