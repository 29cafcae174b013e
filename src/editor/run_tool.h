// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/editor_state.h"
#include "editor/route_pointer.h"

namespace inkflate {

/// Takes one step of a tool: what it does to the gesture, the history, the selection and the view.
void run_tool(EditorTurn& turn, ToTool const& routed);

}  // namespace inkflate
