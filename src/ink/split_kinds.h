// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ink/line_graph.h"

namespace inkflate {

constexpr int kInkKind = 0;
constexpr int kHelpLineKind = 1;

/// Marks the edges that are drawn in blue, and cuts an edge where black turns to blue. colour: relative to the paper.
void split_kinds(LineGraph& graph, Picture const& colour);

}  // namespace inkflate
