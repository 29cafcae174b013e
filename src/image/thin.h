// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "image/grid2.h"

namespace inkflate {

/// The eight pixels around (x, y) as bits, clockwise from the one above; the outside of the picture counts as 0.
unsigned neighbour_bits(Mask const& mask, int x, int y);

/// Clockwise from above, in the order of the bits.
inline constexpr std::array<std::array<int, 2>, 8> kNeighbourSteps = {
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

/// Thins every area to lines of one pixel in its middle: no pixel but line ends could go without tearing or opening
/// something. The number of areas (across corners) and of holes (across sides) stays.
///
/// in      mask: 0 and 255
/// out     255 on the lines
/// cost    O(area * half of the largest width)
/// source  Guo and Hall 1989, algorithm A1; each removal is checked again in turn, so that the topology is safe also
///         where the parallel rule would remove both pixels of a pair
Mask thin(Mask mask);

}  // namespace inkflate
