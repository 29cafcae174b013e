// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "editor/route_pointer.h"

namespace inkflate::support {

/// Someone at the canvas: events go in, cameras and models that come out are looked through from then on, all else is kept.
struct Person {
  PointerState state;
  View view;
  std::vector<ToTool> to_tool;
  std::vector<std::string> actions;
  double time_s = 0;

  void take(RouteStep step) {
    state = std::move(step.state);
    for (auto& each : step.routed) {
      if (auto* tool = std::get_if<ToTool>(&each)) to_tool.push_back(*tool);
      if (auto* camera = std::get_if<ToCamera>(&each)) view.camera = camera->camera;
      if (auto* model = std::get_if<ToModel>(&each)) view.model = model->model;
      if (auto* action = std::get_if<ToAction>(&each)) actions.push_back(action->name);
    }
  }

  void point(PointerEvent const& event) { take(route_pointer(state, event, view)); }

  void point(PointerAction action, PointerKind kind, int id, Vec2 screen,
             PointerButton button = PointerButton::Primary) {
    PointerEvent event;
    event.action = action;
    event.kind = kind;
    event.id = id;
    event.button = action == PointerAction::Move ? PointerButton::None : button;
    event.screen = screen;
    event.time_s = time_s;
    point(event);
  }

  void press(PointerKind kind, int id, Vec2 screen, PointerButton button = PointerButton::Primary) {
    point(PointerAction::Press, kind, id, screen, button);
  }
  void move(PointerKind kind, int id, Vec2 screen) { point(PointerAction::Move, kind, id, screen); }
  void release(PointerKind kind, int id, Vec2 screen,
               PointerButton button = PointerButton::Primary) {
    point(PointerAction::Release, kind, id, screen, button);
  }
  void cancel(PointerKind kind, int id) { point(PointerAction::Cancel, kind, id, {}); }

  /// What tools were told, a letter for each: Press, Move, Hover, Release, Cancel.
  std::string told() const {
    std::string text;
    for (auto const& each : to_tool) text += "PMHRC"[each.event.index()];
    return text;
  }

  /// The pointer of the last event that has one.
  ToolPointer last_pointer() const {
    ToolPointer pointer;
    for (auto const& each : to_tool) {
      if (auto const* press = std::get_if<ToolPress>(&each.event)) pointer = press->pointer;
      if (auto const* move = std::get_if<ToolMove>(&each.event)) pointer = move->pointer;
      if (auto const* hover = std::get_if<ToolHover>(&each.event)) pointer = hover->pointer;
      if (auto const* release = std::get_if<ToolRelease>(&each.event)) pointer = release->pointer;
    }
    return pointer;
  }

  /// Of the last press; 0: there was none.
  int clicks() const {
    int clicks = 0;
    for (auto const& each : to_tool) {
      if (auto const* press = std::get_if<ToolPress>(&each.event)) clicks = press->clicks;
    }
    return clicks;
  }
};

}  // namespace inkflate::support
