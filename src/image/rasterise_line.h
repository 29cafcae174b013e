// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "geometry/vec2.h"
#include "image/grid2.h"

namespace inkflate {

/// Draws the line between the pixels that hold two points, one pixel wide, both ends included. What lies outside
/// the mask is left out; the rest is what would be drawn on a larger mask.
///
/// in      points within 1e6 px
/// cost    O(width + height) of the mask, however long the line
/// source  Bresenham 1965
void rasterise_line(Vec2 from, Vec2 to, Mask& mask, std::uint8_t value = 255);

/// The lines that join the points in order; a single point is one pixel.
void rasterise_polyline(std::span<Vec2 const> points, Mask& mask, std::uint8_t value = 255);

}  // namespace inkflate
