// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyline.h"
#include "image/components.h"
#include "image/grid2.h"

namespace inkflate {

/// Connected pieces: labels 1 ... count in the order of their first pixels, row by row; 0: background.
struct Pieces {
  Grid2<int> labels;
  int count = 0;
};

/// The connected pieces of the pixels that are not 0.
///
/// cost    O(pixels), no recursion
Pieces label_pieces(Mask const& mask, Neighbours neighbours);

/// The boundary of one piece as walks over its own pixels. Points are pixel centres, each next to the one before
/// (8 neighbours), the last next to the first.
struct TracedPiece {
  Contour outer;               // clockwise on the screen
  std::vector<Contour> holes;  // against the clock
};

/// Walks around every piece (4 neighbours) of a mask and around its holes (8 neighbours).
///
/// out     pieces in the order of their first pixels. A walk comes by a pixel twice where the piece is one pixel
///         wide or touches itself at a corner: simple_loops
/// cost    O(pixels + boundary)
/// source  square tracing, thesis section 3.2.1: left on a pixel of the piece, right on any other. To stop at the first
///         return to the start would cut walks short; we stop when the start is entered in the same direction
///         (Jacob's criterion). On pieces that hang together by corners only, square tracing may go on or turn back
///         at a corner, depending on its parity; hence 4 neighbours, each piece traced alone
std::vector<TracedPiece> trace_contours(Mask const& mask);

/// Cuts a walk where it comes by a point again. The loops have distinct points and do not cross themselves;
/// ways there and back and loops without area are left out.
///
/// out     loops in the order in which the walk closes them; those around pieces have positive area, those
///         around holes negative
/// cost    O(n log n)
std::vector<Contour> simple_loops(Contour const& walk);

}  // namespace inkflate
