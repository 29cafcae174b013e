// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/polyline.h"
#include "image/grid2.h"

namespace inkflate {

/// The share of each pixel that closed contours cover (non-zero), in the window of shares whose top left
/// pixel is (left, top).
///
/// in      contours: finite points, px; they may leave the window
/// out     shares: in [0, 1]. Exact area where edges do not cross inside the pixel; where they do, the areas of
///         opposite direction cancel
/// cost    O(pixels + rows met by edges)
/// source  signed-area accumulation as in the font rasterisers of LibArt (Levien) and FreeType
void cover_fill(std::span<Contour const> contours, int left, int top, Grid2<double>& shares);

}  // namespace inkflate
