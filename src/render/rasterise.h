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

/// A part of a picture.
struct PixelBox {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;

  friend bool operator==(PixelBox const&, PixelBox const&) = default;
};

/// Draws a list over a picture that is there already, cut off at a box inside the picture. The list's origin is
/// the top left corner of the picture. Takes 4 bytes of memory for each pixel of the box.
void rasterise_into(DrawList const& list, PixelBox const& box, Picture& picture);

}  // namespace inkflate
