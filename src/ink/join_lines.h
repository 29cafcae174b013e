// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ink/line_graph.h"

namespace inkflate {

/// A line as a pen would have drawn it.
struct JoinedLine {
  Polyline points;
  bool is_closed = false;  // the last point is joined to the first
  int kind = 0;
};

/// Joins edges of one kind through nodes wherever they go on straight, each end with at most one other, the
/// straightest pairs first. Nodes without edges but with ink become lines of one point.
std::vector<JoinedLine> join_lines(LineGraph const& graph);

}  // namespace inkflate
