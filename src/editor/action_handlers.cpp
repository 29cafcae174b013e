// SPDX-License-Identifier: Apache-2.0
#include "editor/action_handlers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/numbers.h"

namespace inkflate {

ActionHandler const* find_handler(std::string_view action) {
  std::array const parts = {edit_handlers(), draw_handlers(), part_handlers(), view_handlers(),
                            tool_handlers(), pin_handlers(),  file_handlers()};
  for (auto const& part : parts) {
    auto const found = std::find_if(part.begin(), part.end(), [&](ActionHandler const& handler) {
      return handler.name == action;
    });
    if (found != part.end()) return &*found;
  }
  return nullptr;
}

void run_action(EditorTurn& turn, std::string_view action, std::string const& argument) {
  if (find_action(action) == nullptr) {
    return say(turn, Severity::Problem, Word::CannotDo,
               {"there is no action \"" + std::string(action.substr(0, 40)) + "\""});
  }
  auto const* const handler = find_handler(action);
  if (handler == nullptr) {
    turn.changes.studio_actions.emplace_back(action);
    return;
  }
  turn.argument = argument;
  handler->run(turn);
}

bool always(EditorState const& /*state*/) { return true; }
bool has_selection(EditorState const& state) { return !state.view.selection.empty(); }
bool has_pin(EditorState const& state) { return state.view.pin.has_value(); }
bool has_pin_or_selection(EditorState const& state) {
  return has_pin(state) || has_selection(state);
}

std::optional<double> number_of(std::string_view argument) {
  auto rest = trimmed(argument);
  auto const number = take_number(rest);
  return number && rest.empty() && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<Vec2> place_of(std::string_view argument) {
  auto const comma = argument.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  auto const x = number_of(argument.substr(0, comma));
  auto const y = number_of(argument.substr(comma + 1));
  return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

void refuse_argument(EditorTurn& turn) {
  say(turn, Severity::Problem, Word::CannotDo,
      {"\"" + turn.argument.substr(0, 40) + "\" is not what this action takes"});
}

}  // namespace inkflate
