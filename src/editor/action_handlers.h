// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "editor/editor_state.h"

namespace inkflate {

/// What an action does, and whether it would do something now.
struct ActionHandler {
  std::string_view name;
  void (*run)(EditorTurn& turn) = nullptr;
  bool (*is_enabled)(EditorState const& state) = nullptr;
};

/// In parts, as their files are.
std::span<ActionHandler const> edit_handlers();
std::span<ActionHandler const> draw_handlers();
std::span<ActionHandler const> part_handlers();
std::span<ActionHandler const> view_handlers();
std::span<ActionHandler const> tool_handlers();
std::span<ActionHandler const> pin_handlers();
std::span<ActionHandler const> file_handlers();

/// Null: an action that the studio does itself.
ActionHandler const* find_handler(std::string_view action);

/// Does an action by its name. What the studio has to do goes to Changes::studio_actions. An unknown name is said.
void run_action(EditorTurn& turn, std::string_view action, std::string const& argument);

/// Rules for is_enabled that more than one part has.
bool always(EditorState const& state);
bool has_selection(EditorState const& state);
bool has_pin(EditorState const& state);
bool has_pin_or_selection(EditorState const& state);

/// The argument as a number; nothing when it is none.
std::optional<double> number_of(std::string_view argument);
/// "12.5,40" as a place.
std::optional<Vec2> place_of(std::string_view argument);
/// Says that the argument is not what the action takes.
void refuse_argument(EditorTurn& turn);

/// What actions take from one another.
void simplify_document(EditorTurn& turn);
void open_file(EditorTurn& turn, FileEvent const& file);
/// So that everything that was drawn is in view.
void fit_paper(EditorTurn& turn);

}  // namespace inkflate
