// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyline.h"
#include "image/grid2.h"

namespace inkflate {

/// A place where lines end or meet.
struct LineNode {
  Vec2 position;         // px
  double radius_px = 0;  // of the ink there
};

/// A line of one pixel between two nodes, which are not among its points.
struct LineEdge {
  Polyline points;  // pixel centres in order
  int from = -1;    // node; -1 for both: a closed line that meets no other
  int to = -1;
  int kind = 0;  // lines of different kinds are never joined
};

struct LineGraph {
  std::vector<LineNode> nodes;
  std::vector<LineEdge> edges;
};

/// The graph of a thinned mask. Cost: O(pixels).
///
/// in      lines: as thin() makes them; radius_px: of the ink at each pixel
LineGraph line_graph(Mask const& lines, Grid2<double> const& radius_px);

/// Removes what thinning adds to a drawing: the short spurs towards the corners of thick lines.
void prune_spurs(LineGraph& graph);

/// Makes one node of the two into which thinning splits a crossing.
void merge_crossings(LineGraph& graph);

/// How many line ends each node has.
std::vector<int> node_degrees(LineGraph const& graph);

}  // namespace inkflate
