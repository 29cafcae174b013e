// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "editor/action_handlers.h"
#include "editor/bend_gesture.h"
#include "io/svg_colour.h"

namespace inkflate {
namespace {

constexpr double kSizeStep = 1.25;

/// A tool works on the drawing: choosing one goes there.
template <Tool kTool>
void choose(EditorTurn& turn) {
  auto& view = turn.state.view;
  view.tool = kTool;
  view.mode = Mode::Draw;
  turn.changes.is_scene_changed = turn.changes.is_state_changed = true;
}

void settings_changed(EditorTurn& turn) { turn.changes.is_state_changed = true; }

/// The brackets change the size of the tool that is held.
void size_by(EditorTurn& turn, double factor) {
  auto& settings = turn.state.view.settings;
  if (turn.state.view.tool == Tool::Deform) return change_bend_reach(turn, factor);
  if (turn.state.view.tool == Tool::Eraser) {
    settings.eraser_px = std::clamp(settings.eraser_px * factor, ToolSettings::kLeastEraserPx,
                                    ToolSettings::kLargestEraserPx);
  } else {
    settings.brush_px = std::clamp(settings.brush_px * factor, ToolSettings::kLeastBrushPx,
                                   ToolSettings::kLargestBrushPx);
  }
  settings_changed(turn);
}

void set_number(EditorTurn& turn, double ToolSettings::*member, double least, double most) {
  auto const number = number_of(turn.argument);
  if (!number || *number < least || *number > most) return refuse_argument(turn);
  turn.state.view.settings.*member = *number;
  settings_changed(turn);
}

void brush_size(EditorTurn& turn) {
  set_number(turn, &ToolSettings::brush_px, ToolSettings::kLeastBrushPx,
             ToolSettings::kLargestBrushPx);
}

void eraser_size(EditorTurn& turn) {
  set_number(turn, &ToolSettings::eraser_px, ToolSettings::kLeastEraserPx,
             ToolSettings::kLargestEraserPx);
}

void smoothing(EditorTurn& turn) { set_number(turn, &ToolSettings::smoothing, 0, 1); }

void ink_colour(EditorTurn& turn) {
  auto const colour = parse_colour(turn.argument);
  if (!colour) return refuse_argument(turn);
  turn.state.view.settings.ink = *colour;
  settings_changed(turn);
}

void bend_mode(EditorTurn& turn) {
  bool const is_wire = turn.argument == "wire";
  if (!is_wire && turn.argument != "body") return refuse_argument(turn);
  turn.state.view.settings.bend_mode = is_wire ? BendMode::Wire : BendMode::Body;
  settings_changed(turn);
}

void bend_body(EditorTurn& turn) {
  set_number(turn, &ToolSettings::bend_body, BendOptions::kLeastBody, 1);
}

/// "auto", "whole", or a share of the part.
void bend_reach(EditorTurn& turn) {
  auto& reach = turn.state.view.settings.bend_reach;
  auto const share = turn.argument == "whole" ? std::optional(1.0) : number_of(turn.argument);
  bool const is_share = share && *share >= ToolSettings::kLeastBendReach && *share <= 1;
  if (!is_share && turn.argument != "auto") return refuse_argument(turn);
  reach = share;
  settings_changed(turn);
}

constexpr std::array kHandlers = {
    ActionHandler{"brush", choose<Tool::Brush>, always},
    ActionHandler{"help_line", choose<Tool::HelpLine>, always},
    ActionHandler{"eraser", choose<Tool::Eraser>, always},
    ActionHandler{"mark", choose<Tool::Mark>, always},
    ActionHandler{"deform", choose<Tool::Deform>, always},
    ActionHandler{"select_tool", choose<Tool::Select>, always},
    ActionHandler{"hand", choose<Tool::Hand>, always},
    ActionHandler{"brush_larger", [](EditorTurn& turn) { size_by(turn, kSizeStep); }, always},
    ActionHandler{"brush_smaller", [](EditorTurn& turn) { size_by(turn, 1 / kSizeStep); }, always},
    ActionHandler{"brush_size", brush_size, always},
    ActionHandler{"eraser_size", eraser_size, always},
    ActionHandler{"smoothing", smoothing, always},
    ActionHandler{"ink_colour", ink_colour, always},
    ActionHandler{"bend_mode", bend_mode, always},
    ActionHandler{"bend_body", bend_body, always},
    ActionHandler{"bend_reach", bend_reach, always},
};

}  // namespace

std::span<ActionHandler const> tool_handlers() { return kHandlers; }

}  // namespace inkflate
