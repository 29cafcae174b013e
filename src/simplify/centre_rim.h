// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/point_grid.h"
#include "simplify/rim.h"

namespace inkflate {

struct CentreOptions {
  // > 0, work px; no stroke farther inside than this belongs to the outline.
  double reach_px = 16;
  // > 0, work px; strokes farther apart than this are two lines, not one that was drawn twice.
  double gap_px = 7;
};

/// Where the outline is meant to run. The cut follows the outermost of overdrawn strokes; this moves every corner of the rim to the
/// middle of the strokes that run beside it, and then evens out the moves along the rim.
///
/// in      rim: simple; grid: of the positions of all samples
/// out     one position per rim corner, work px. Thin places move at most a third of their width; even so nothing is promised about
///         crossings
/// cost    O(rim corners * samples within reach)
Contour centre_rim(Rim const& rim, StrokeSamples const& samples, PointGrid const& grid,
                   CentreOptions const& options = {});

}  // namespace inkflate
