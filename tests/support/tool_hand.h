// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "document/document.h"
#include "editor/tool.h"

namespace inkflate {

/// A hand that works with a tool, for tests: it keeps what an engine keeps between events, and nothing else.
class ToolHand {
 public:
  ToolHand(Tool tool, Document document);

  /// What the tool does at a place of the screen; time goes on by 10 ms.
  Step press(Vec2 screen, int clicks = 1);
  Step move(Vec2 screen);
  Step hover(Vec2 screen);
  Step release(Vec2 screen);
  Step cancel();
  /// Pressed, moved in a few steps, released.
  Step drag(Vec2 from, Vec2 to);
  Step click(Vec2 screen, int clicks = 1);

  View view;            // that the tool looks at: selection, hover and camera follow its steps
  Modifiers modifiers;  // that are held
  bool is_secondary = false;
  double pressure = 1;

  /// With the gesture under way.
  Document const& document() const { return shown_; }
  ToolState const& state() const { return state_; }
  int entries() const { return entries_; }  // of a history: gestures that have changed something
  /// A command has been refused by apply.
  bool was_refused() const { return was_refused_; }

 private:
  ToolPointer pointer(Vec2 screen);
  Step take(ToolEvent const& event);

  Tool tool_;
  Document before_;  // as it was at the press
  Document shown_;
  std::vector<Command> gesture_;
  ToolState state_;
  double time_s_ = 100;
  int entries_ = 0;
  bool was_refused_ = false;
};

}  // namespace inkflate
