// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "solidify/line_spans.h"

namespace inkflate {

/// A ball that is added to the solid; lattice units.
struct Ball {
  Vec3 centre;
  double radius = 0;
  int triangle = 0;  // of the model, one that bounds the thin place
};

/// Balls that make thin places as thick as wanted and close slits that the lattice cannot show.
///
/// in      least: thickness, lattice units
/// out     no two centres in one small cell; in a fixed order
/// cost    O(n log n) in the balls found
/// source  docs/algorithms/solidify.md
std::vector<Ball> fill_balls(LatticeMesh const& mesh, std::span<LineSpans const> families,
                             double least);

}  // namespace inkflate
