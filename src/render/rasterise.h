// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"
#include "render/draw_list.h"

namespace inkflate {

/// Draws a list into a picture, antialiased, without a window or a GPU; the same bytes on every machine.
///
/// in      list: finite coordinates, px; items may leave the picture
///         width, height: 0 .. 16384; background may be transparent
/// out     width x height pixels, items composited in order with their alpha (not gamma corrected)
/// cost    O(pixels touched): 300 strokes on 1000 x 1000 about 20 ms
Picture rasterise(DrawList const& list, int width, int height, Colour background);

}  // namespace inkflate
