// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "editor/action_handlers.h"
#include "editor/pick.h"
#include "editor/turn_step.h"

namespace inkflate {
namespace {

constexpr double kZoomStep = 1.25;

void view_changed(EditorTurn& turn) {
  turn.changes.is_scene_changed = turn.changes.is_state_changed = true;
}

Vec2 middle(View const& view) { return {view.size.width_px / 2, view.size.height_px / 2}; }

bool is_drawing(EditorState const& state) { return state.view.mode == Mode::Draw; }
bool is_turning(EditorState const& state) { return !is_drawing(state); }

void draw(EditorTurn& turn) {
  turn.state.view.mode = Mode::Draw;
  view_changed(turn);
}

/// Strokes that are still rough are closed first: whoever wants a model wants all of the drawing in it.
void show_model(EditorTurn& turn, Mode mode) {
  auto& state = turn.state;
  if (has_rough_strokes(state.history.document()) && state.view.mode == Mode::Draw) {
    simplify_document(turn);
  }
  if (shown_drawing(state.history.document()).layers.empty()) {
    return say(turn, Severity::Warning, Word::NothingToInflate);
  }
  state.view.mode = mode;
  view_changed(turn);
}

/// The paper in Draw, the model in the other modes.
void zoom_by(EditorTurn& turn, double factor) {
  auto& view = turn.state.view;
  if (view.mode == Mode::Draw) {
    view.camera = zoomed(view.camera, view.size, middle(view), factor);
  } else {
    view.model = zoomed(view.model, view.size, middle(view), factor);
  }
  view_changed(turn);
}

void zoom_actual(EditorTurn& turn) {
  auto& view = turn.state.view;
  if (view.mode == Mode::Draw) {
    view.camera = zoomed(view.camera, view.size, middle(view), 1 / view.camera.zoom);
  } else {
    view.model.zoom = 1;
    view.model.pan_px = {};
  }
  view_changed(turn);
}

void fit(EditorTurn& turn, Rect const& box) {
  auto& view = turn.state.view;
  view.camera = fitted(view.camera, view.size, box);
  view_changed(turn);
}

void zoom_selection(EditorTurn& turn) {
  auto const& view = turn.state.view;
  if (view.selection.empty()) return say(turn, Severity::Warning, Word::NothingSelected);
  fit(turn, box_of(turn.state.history.document(), view.selection));
}

/// "x,y,width,height" on the canvas: where a message says to look.
void show_place(EditorTurn& turn) {
  auto const comma = turn.argument.find(',', turn.argument.find(',') + 1);
  if (comma == std::string::npos) return refuse_argument(turn);
  auto const corner = place_of(turn.argument.substr(0, comma));
  auto const size = place_of(turn.argument.substr(comma + 1));
  if (!corner || !size) return refuse_argument(turn);
  turn.state.view.mode = Mode::Draw;
  fit(turn, {*corner, *corner + *size});
}

void mirror(EditorTurn& turn) {
  auto& camera = turn.state.view.camera;
  camera = mirrored(camera);
  view_changed(turn);
}

void toggle_grid(EditorTurn& turn) {
  auto& view = turn.state.view;
  view.has_grid = !view.has_grid;
  view_changed(turn);
}

void look(EditorTurn& turn) {
  auto& shading = turn.state.view.shading;
  if (turn.argument == "matcap") {
    shading = Shading::Matcap;
  } else if (turn.argument == "textured") {
    shading = Shading::Textured;
  } else if (turn.argument == "lines") {
    shading = Shading::Lines;
  } else {
    return refuse_argument(turn);
  }
  view_changed(turn);
}

template <int kTurns, int kTilts>
void turn_model(EditorTurn& turn) {
  auto& model = turn.state.view.model;
  model = turned(model, kTurns * kTurnStepRad, kTilts * kTurnStepRad);
  view_changed(turn);
}

void reset_turn(EditorTurn& turn) {
  turn.state.view.model = {};
  view_changed(turn);
}

constexpr std::array kHandlers = {
    ActionHandler{"mode_draw", draw, always},
    ActionHandler{"mode_inflate", [](EditorTurn& turn) { show_model(turn, Mode::Inflate); },
                  always},
    ActionHandler{"mode_animate", [](EditorTurn& turn) { show_model(turn, Mode::Animate); },
                  always},
    ActionHandler{"zoom_in", [](EditorTurn& turn) { zoom_by(turn, kZoomStep); }, always},
    ActionHandler{"zoom_out", [](EditorTurn& turn) { zoom_by(turn, 1 / kZoomStep); }, always},
    ActionHandler{"zoom_actual", zoom_actual, always},
    ActionHandler{"zoom_fit", [](EditorTurn& turn) { fit_paper(turn); }, always},
    ActionHandler{"zoom_selection", zoom_selection, has_selection},
    ActionHandler{"show_place", show_place, always},
    ActionHandler{"mirror_view", mirror, is_drawing},
    ActionHandler{"grid", toggle_grid, always},
    ActionHandler{"look", look, is_turning},
    ActionHandler{"turn_left", turn_model<-1, 0>, is_turning},
    ActionHandler{"turn_right", turn_model<1, 0>, is_turning},
    ActionHandler{"turn_up", turn_model<0, 1>, is_turning},
    ActionHandler{"turn_down", turn_model<0, -1>, is_turning},
    ActionHandler{"reset_turn", reset_turn, is_turning},
};

}  // namespace

std::span<ActionHandler const> view_handlers() { return kHandlers; }

void fit_paper(EditorTurn& turn) {
  auto const& document = turn.state.history.document();
  auto box = box_of(document);
  if (box.is_empty()) box = {{0, 0}, {document.width_px, document.height_px}};
  fit(turn, box);
}

}  // namespace inkflate
