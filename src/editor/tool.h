// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "document/command.h"
#include "editor/events.h"
#include "editor/view.h"

namespace inkflate {

/// A pointer as tools see it: finite, on the canvas, with time that does not run backwards. What is not finite is taken for nothing,
/// and a release so for a cancel.
struct ToolPointer {
  Vec2 canvas;
  Vec2 screen;
  double pressure = 1;  // 0 .. 1; 1 for a mouse
  double time_s = 0;
  bool is_secondary = false;  // right button: the far side
  Modifiers modifiers;
};

struct ToolPress {
  ToolPointer pointer;
  int clicks = 1;  // 2: the second press of a double click
};
struct ToolMove {
  ToolPointer pointer;  // while pressed
};
struct ToolHover {
  ToolPointer pointer;  // while not
};
struct ToolRelease {
  ToolPointer pointer;
};
struct ToolCancel {};  // Esc, a second finger, a lost pointer: the gesture never was

using ToolEvent = std::variant<ToolPress, ToolMove, ToolHover, ToolRelease, ToolCancel>;

/// What a tool is in the midst of. Plain values.

struct ToolIdle {};

/// A line is being drawn.
struct ToolDrawing {
  Stroke raw;                // as it came
  Stroke smooth;             // what it will be
  double start_s = 0;        // time of the press
  bool is_straight = false;  // smooth is the line from the press to the pointer
};

/// Area eraser: erased up to here.
struct ToolErasing {
  Vec2 last;             // canvas px
  bool has_met = false;  // something to erase
};

/// Line eraser: what lay between here and the press is gone.
struct ToolErasingLines {
  Vec2 last;  // canvas px
  bool has_met = false;
};

/// Pressed, not yet moved far enough to be a drag.
struct ToolPressedOn {
  ToolPointer from;
  LayerId layer = LayerId::None;  // that was picked; None: there was none
  int clicks = 1;
};

/// A box is drawn around layers.
struct ToolBoxing {
  Vec2 from;  // canvas px
  Vec2 to;
  std::vector<LayerId> before;  // selection at the press: kept with Shift, and after a cancel
};

/// What of a selection's frame is held.
enum class FrameHandle {
  Inside,
  Left,
  Right,
  Top,
  Bottom,
  TopLeft,
  TopRight,
  BottomLeft,
  BottomRight,
  Turn
};

/// The selection is moved, scaled or turned.
struct ToolTransforming {
  FrameHandle handle = FrameHandle::Inside;
  ToolPointer from;
  Rect box;  // of the selection at the press, canvas px
  std::vector<LayerId> layers;
  bool is_copy = false;  // with Alt at the start: the layers stay, copies of them are moved
};

/// The paper is moved.
struct ToolPanning {
  Vec2 last;  // screen px
};

using ToolState = std::variant<ToolIdle, ToolDrawing, ToolErasing, ToolErasingLines, ToolPressedOn,
                               ToolBoxing, ToolTransforming, ToolPanning>;

/// How the commands of a step change the gesture that is under way.
enum class GestureEffect {
  None,     // not at all
  Replace,  // the gesture is these commands, on the document as it was at the press
  Append,   // the gesture is what it was, and these commands
};

/// What a tool makes of one event.
struct Step {
  ToolState state;
  GestureEffect effect = GestureEffect::None;
  std::vector<Command> commands = {};
  bool is_end =
      false;  // the gesture is over: what it did becomes one entry of the history. Cancelled gestures end with Replace by nothing
  std::optional<std::vector<LayerId>> selection = {};
  std::optional<Camera> camera = {};
  std::optional<LayerId> hover = {};
  std::string action = {};    // to be done after the gesture: a name of actions.h
  std::string argument = {};  // of it
};

/// What tools may look at.
struct ToolContext {
  Document const& document;  // with the gesture so far
  View const& view;
};

/// One transition of a tool's state machine. It touches nothing: same input, same step.
///
/// in      a press only when idle; moves, releases only when not; the state is one that this tool gave. Events that come otherwise
///         change nothing
/// out     no command that apply would refuse with NothingThere
/// cost    while drawing O(1) amortised, if the state is moved in; O(layers) where something is picked, O(strokes) for the eraser
Step tool_step(Tool tool, ToolState state, ToolEvent const& event, ToolContext const& context);

}  // namespace inkflate
