// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "geometry/vec2.h"

namespace inkflate {

/// What a studio hands to the engine. All numbers come from outside: any may be NaN, infinite, or run backwards.

struct Modifiers {
  bool is_shift = false;
  bool is_ctrl = false;  // Cmd where that is the custom
  bool is_alt = false;

  friend bool operator==(Modifiers const&, Modifiers const&) = default;
};

enum class PointerKind { Mouse, Pen, Touch };

enum class PointerAction { Press, Move, Release, Cancel };

/// The buttons of Pointer Events.
enum class PointerButton {
  None,     // hovering, or a move
  Primary,  // left; a finger; the tip of a pen
  Middle,
  Secondary,  // right; the button of a pen
  Eraser,     // the other end of a pen
};

struct PointerEvent {
  PointerAction action = PointerAction::Move;
  PointerKind kind = PointerKind::Mouse;
  int id = 0;  // of the mouse, pen or finger, from its press to its release
  PointerButton button = PointerButton::None;  // that was pressed or released
  Vec2 screen;                                 // px of the view, origin top left
  double pressure = 0.5;                       // 0 .. 1; 0.5 where there is none to measure
  double time_s = 0;
  Modifiers modifiers;
};

/// A key by the name that browsers give it: "a", "Z", "Enter", "ArrowLeft", " ".
struct KeyEvent {
  std::string key;
  bool is_press = true;
  bool is_repeat = false;
  double time_s = 0;
  Modifiers modifiers;
};

struct WheelEvent {
  Vec2 screen;
  Vec2 delta_px;  // positive: content moves up and left
  Modifiers modifiers;
};

/// A pinch that the system has recognised, as trackpads give it.
struct GestureEvent {
  Vec2 screen;
  double scale = 1;  // since the event before
  Vec2 moved_px;     // since the event before
};

/// An action by its name (actions.h), as menus, buttons and palettes call it.
struct ActionEvent {
  std::string name;
  std::string argument =
      {};  // for actions that take one: a name, a number, a colour, a place "x,y"
};

enum class FileUse {
  Open,      // takes the place of the document
  Add,       // its strokes and layers come to those that are there
  Template,  // a picture to trace and to wear
};

/// The bytes of a file that was opened, dropped or pasted.
struct FileEvent {
  std::vector<std::byte> bytes;
  std::string name = {};
  FileUse use = FileUse::Open;
};

/// How far bars and panels of the studio reach into the view from its edges, px of the screen.
struct ViewEdges {
  double left_px = 0;
  double top_px = 0;
  double right_px = 0;
  double bottom_px = 0;

  friend bool operator==(ViewEdges const&, ViewEdges const&) = default;
};

/// The view's size in px of the screen.
struct ResizeEvent {
  double width_px = 0;
  double height_px = 0;
  ViewEdges edges = {};
};

using Event = std::variant<PointerEvent, KeyEvent, WheelEvent, GestureEvent, ActionEvent, FileEvent,
                           ResizeEvent>;

}  // namespace inkflate
