// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "solidify/fill_balls.h"
#include "solidify/lattice.h"
#include "solidify/line_spans.h"
#include "solidify/node_stretches.h"

namespace inkflate {

struct Reach {
  double share = 0;         // of the step, 0 .. 1
  bool is_of_ball = false;  // a ball's surface is met there, not the model's
};

/// The union of the shells and the balls, as seen from the lattice. Lattice units.
struct Solid {
  Lattice lattice;
  std::vector<LineSpans> families;  // seven
  std::vector<Ball> balls;
  std::vector<int>
      ball_of_node;  // the ball in which the node lies deepest, or -1; empty without balls
  double base = 0;   // nothing lies below this k
  std::vector<NodeSide> sides;  // per node; what cannot be reached from outside is inside

  /// How far the solid reaches on the way from a node that is inside to its neighbour in direction d that is outside.
  Reach reach(LatticeNode from, int direction) const;
};

}  // namespace inkflate
