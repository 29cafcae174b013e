// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "image/grid2.h"
#include "model/stroke.h"

namespace inkflate {

enum class HelpLineInk {
  Blue,  // lines clearly blue or teal are help lines, unless most of the drawing is
  None,
};

struct ScanOptions {
  int work_side_px = 1600;     // 64 .. 8192; larger pictures are shrunk to this for the work
  double ink_threshold = 0.7;  // 0.1 .. 2; as a share of Otsu's; smaller finds fainter ink
  HelpLineInk help_line_ink = HelpLineInk::Blue;
};

/// Turns a scanned or photographed drawing into strokes along the middle of its lines.
///
/// in      picture: dark lines on light paper (uneven light is fine), or light lines on a dark ground; clear
///         pixels count as white paper. A table in sight around the sheet is left out, and 1.5 % of the picture's
///         longer side within the sheet's edge
/// out     strokes in px of the picture, joined through crossings in the straightest way; each with one width and
///         colour (that of the ink in even light); help lines by their colour. A solid area comes as the closed line
///         around it: its last sample repeats the first. Lines drawn on a dark ground come with their lightness
///         turned round
/// errors  BadOption; NothingThere (an empty page); Cancelled
/// cost    O(pixels): 12 megapixels about 0.2 s, 1000 x 1000 about 0.1 s
/// source  threshold: Otsu 1979; thinning: Guo and Hall 1989; distances: Felzenszwalb and Huttenlocher 2012
Result<Sketch> trace_scan(Picture const& picture, ScanOptions const& options = {},
                          Progress const& progress = {});

}  // namespace inkflate
