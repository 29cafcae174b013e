// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/polyline.h"
#include "image/grid2.h"
#include "model/drawing.h"

namespace inkflate {

/// Splits traced contours into straight lines. A line ends at the first traced pixel where it is longer than
/// min_line_length_px along the pixels; the last one of a contour ends at its start, however short. A line is a
/// help line when any of its pixels is one.
///
/// in      loops: of one layer, each as simple_loops (image/trace_contour.h) makes them
///         help_lines: the help lines, drawn as wide as they shall be noticed
/// out     one outline per loop. Lines that would cross or touch others are replaced by their single pixel steps,
///         so an outline is simple whatever the length
/// cost    O(n log n) for short lines
/// source  thesis section 5.4.2
std::vector<Outline> outlines_of(std::span<Contour const> loops, Mask const& help_lines,
                                 double min_line_length_px);

}  // namespace inkflate
