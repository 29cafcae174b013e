// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "editor/events.h"
#include "editor/tool.h"
#include "editor/view.h"

namespace inkflate {

/// A finger or pen or mouse that is down.
struct DownPointer {
  int id = 0;
  PointerKind kind = PointerKind::Mouse;
  PointerButton button = PointerButton::Primary;
  Vec2 first;  // screen px
  Vec2 last;
  double farthest_px = 0;  // from first, so far
  double first_time_s = 0;
  bool is_ignored = false;  // until it is lifted: a palm, or its gesture was taken over or dropped
};

/// What the pointers are doing together.
enum class PointerUse {
  None,
  Tool,     // one pointer works with a tool
  Pan,      // one moves the paper or the model: Space, middle button, a finger where a pen draws
  Turn,     // one turns the model
  Pinch,    // two or more fingers move and zoom
  Ignored,  // the finger that is left of a pinch: it waits for another to go on
};

/// Everything that has to be remembered between pointer events. A plain value.
struct PointerState {
  std::vector<DownPointer> down;
  PointerUse use = PointerUse::None;
  int tool_pointer = -1;       // id, for Tool, Pan, Turn
  Tool tool = Tool::Brush;     // that the gesture works with: Eraser for a pen's other end
  ToolPointer pointer;         // the last that this tool was told of
  bool is_space_held = false;  // the engine sets it as it hears of the key
  bool was_pen_seen = false;   // then fingers pan and zoom
  double last_pen_time_s = -1e9;
  double last_time_s = 0;     // events never go back behind it
  double fingers_from_s = 0;  // when the first finger of this touch gesture came
  int fingers_at_most = 0;    // of this touch gesture: two tapped undo, three redo
  bool has_pinched = false;   // moved far or long enough to be no tap
  Vec2 last_press;            // for double clicks
  double last_press_time_s = -1e9;
  PointerKind last_press_kind = PointerKind::Mouse;
  PointerButton last_press_button = PointerButton::None;
  int clicks = 0;  // of the last press; 0: it was no click
};

/// What one event means.
struct ToTool {
  Tool tool = Tool::Brush;
  ToolEvent event;
};
struct ToCamera {
  Camera camera;
};
struct ToModel {
  ModelView model;
};
struct ToAction {
  std::string name;
};
/// The wheel, while the Deform tool is held down.
struct ToBendReach {
  double factor = 1;  // > 0
};
using Routed = std::variant<ToTool, ToCamera, ToModel, ToAction, ToBendReach>;

struct RouteStep {
  PointerState state;
  std::vector<Routed> routed;
};

/// Sorts pointers out: which one draws, which pan, pinch or are a palm; drops what is not finite. For every ToolPress there
/// comes one ToolRelease or ToolCancel before the next, whatever is lost or comes twice: moves come only between the two, hovers
/// only outside of them. A pointer that comes down while another works takes over, and what was done so far stays.
///
/// in      view: finite, in a size above 0
/// out     pointers of tools lie within DocumentLimits::kFarthestPx, their time never runs backwards
RouteStep route_pointer(PointerState const& state, PointerEvent const& event, View const& view);
RouteStep route_wheel(PointerState const& state, WheelEvent const& event, View const& view);
RouteStep route_gesture(PointerState const& state, GestureEvent const& event, View const& view);

/// Esc, a change of mode, another document: what is down no longer counts until it is lifted.
RouteStep drop_pointers(PointerState const& state);

}  // namespace inkflate
