// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "document/document.h"
#include "image/grid2.h"

namespace inkflate {

/// Small pictures of what was drawn, in the look that it has on the canvas, without grid and marks.

/// The longer side of the smallest and the largest picture.
inline constexpr int kLeastPictureSidePx = 8;
inline constexpr int kLargestPictureSidePx = 2048;

/// One layer on a clear ground, filling a square but for a margin; a hidden one as if it were shown.
///
/// in      side_px: taken into the limits
/// cost    that of its draw list and of rasterise
Picture picture_of_layer(DocumentLayer const& layer, int side_px);

/// All that is visible, on paper, in a square.
Picture picture_of_document(Document const& document, int side_px);

}  // namespace inkflate
