// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "geometry/vec2.h"
#include "image/grid2.h"

namespace inkflate {

/// The energy's weights; defaults: thesis section 5.4.2.
struct GridWeights {
  std::int32_t ink = 3;           // > 0; between neighbours of which one is ink
  std::int32_t paper = 17;        // > 0; between others
  std::int32_t terminal = 10000;  // > 0; between a pixel whose label is known and its terminal

  friend bool operator==(GridWeights const&, GridWeights const&) = default;
};

/// The pixels that belong to the shape when the labels x of all pixels, 1 inside and 0 outside, minimise the sum of
/// w_ij |x_i - x_j| over neighbours (4). Ink is inside, the outermost pixels of the picture are outside, even
/// under ink.
///
/// in      ink: 255 where a stroke is; all weights at most 10^8
///         outside, inside: marks. Each stands for the largest disc round it without ink, since a single pixel
///         would be cut out alone; marks beyond the picture are left out
/// out     255 inside. Of several minima the one with the fewest pixels inside
/// cost    about 100 to 400 ms for 1024 x 1024; 70 bytes per pixel
/// source  thesis section 3.2, eq. 3.4
Mask cut_grid(Mask const& ink, GridWeights const& weights, std::span<Vec2 const> outside = {},
              std::span<Vec2 const> inside = {});

}  // namespace inkflate
