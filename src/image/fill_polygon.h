// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "geometry/polyline.h"
#include "image/grid2.h"

namespace inkflate {

/// Sets the pixels around whose centre the contours wind at all (non-zero). Of two polygons that share an edge (with
/// the same end points) exactly one gets a centre on it.
///
/// in      contours with finite points; fewer than three points fill nothing
/// cost    O(n log n + per row of the mask: its crossings and its pixels)
void fill_polygon(std::span<Contour const> contours, Mask& mask, std::uint8_t value = 255);

}  // namespace inkflate
