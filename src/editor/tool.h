// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "document/command.h"
#include "editor/events.h"
#include "editor/message.h"
#include "editor/view.h"
#include "pipeline/bend_session.h"

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
  bool is_finger = false;  // points less exactly than a mouse or a pen
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

/// What a press with the Deform tool means, as long as it is no drag.
enum class BendPress {
  Nothing,
  Locked,  // a part that cannot be bent
  Inside,  // of a part, away from its line
  Line,
  Pin,
  Knob,  // of the selected pin: a drag turns it
};

/// Pressed to bend, not yet moved far enough to be a drag.
struct ToolPressedToBend {
  ToolPointer from;
  BendPress on = BendPress::Nothing;
  BendGrab what = {};  // that a drag would hold; means nothing for Nothing and Locked
};

/// A place of a line or a pin is dragged.
struct ToolBending {
  BendGrab what;
  ToolPointer from;
  Vec2 target;                          // where the held place shall go, canvas px
  std::optional<double> turn_rad = {};  // of the pin that is turned, since the press
  double hand_rad = 0;                  // how far the hand has gone around it
  Vec2 last = {};                       // where the hand was, canvas px
  std::optional<double> ring_px = {};   // the reach on the canvas, once it was changed in this drag
};

using ToolState =
    std::variant<ToolIdle, ToolDrawing, ToolErasing, ToolErasingLines, ToolPressedOn, ToolBoxing,
                 ToolTransforming, ToolPanning, ToolPressedToBend, ToolBending>;

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
  std::optional<std::optional<BendPinRef>> pin = {};  // that is selected now; inside none: no pin
  /// What shall be bent so: more than a function of plain values does.
  std::optional<ToolBending> bend = {};
  std::optional<Word> word = {};  // why there is nothing to do
  std::string action = {};        // to be done after the gesture: a name of actions.h
  std::string argument = {};      // of it
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
