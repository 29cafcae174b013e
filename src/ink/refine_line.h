// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"
#include "ink/join_lines.h"

namespace inkflate {

/// A line in the middle of its ink.
struct RefinedLine {
  Polyline points;  // about 2.5 px apart; a closed line repeats its first point at the end
  double width_px = 0;
};

/// Moves a line of pixel steps to the middle of the ink across it and takes the steps out.
///
/// in      line: within about 1.5 px of the middle; strength, radius_px: of the same picture
/// out     width: the mean over the line of the ink across it, where no other line is near
/// cost    O(points * width)
RefinedLine refine_line(JoinedLine const& line, Mask const& strength,
                        Grid2<double> const& radius_px);

}  // namespace inkflate
