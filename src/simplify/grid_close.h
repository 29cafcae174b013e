// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "model/drawing.h"
#include "simplify/grid_cut.h"
#include "simplify/simplify.h"

namespace inkflate {

struct GridOptions {
  GridWeights weights;  // each 1 ... 10^8
  double min_line_length_px =
      3;                      // >= 0; the thesis' MIN_LINE_LEN, of which it does not tell the value
  Holes holes = Holes::Fill;  // the thesis: only outer contours are traced
  std::vector<Vec2> outside;  // finite; see cut_grid
  std::vector<Vec2> inside;   // finite; see cut_grid
};

/// The largest raster: 70 bytes per pixel are 1.2 GB then.
inline constexpr int kMaxGridSidePx = 4096;

/// Closes a rough sketch on the pixels of its canvas, as the thesis does it: strokes are drawn one pixel wide, a
/// minimum cut fills what they nearly enclose, opening by 3 x 3 pixels takes thin parts off, and the rest is traced. For
/// comparison: closings run along the axes, and the outline's tie to the strokes is lost.
///
/// in      sketch: samples finite, within 1e6 px; strokes beyond the canvas are clipped
/// out     a layer per separate piece, in the order of their first pixels; its outlines are straight lines between
///         pixel centres, of kind Ink or HelpLine. Every outline is closed and simple; a piece that is joined by
///         single pixels falls into several layers. Sources, strokes and details stay empty
/// errors  BadOption; BadInput (canvas without size, bad sample: index is the stroke's); TooLarge; NothingThere;
///         Cancelled
/// cost    as cut_grid
/// source  thesis sections 3.2 and 5.4.2
Result<std::vector<Layer>> close_on_grid(Sketch const& sketch, GridOptions const& options = {},
                                         Progress const& progress = {});

}  // namespace inkflate
