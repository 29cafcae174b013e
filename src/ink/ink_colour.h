// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/vec2.h"
#include "image/grid2.h"

namespace inkflate {

/// Whether a colour, relative to white paper, is that of a blue or teal pencil.
bool is_blue(Colour colour);

/// The median of each channel at the pixels under the points; at least one point.
Colour median_colour(Picture const& picture, std::span<Vec2 const> points);

}  // namespace inkflate
