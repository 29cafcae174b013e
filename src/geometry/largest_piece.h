// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/nonzero_boundary.h"

namespace inkflate {

/// The largest piece of an area: its outer contour, then its holes. Empty where there is none.
///
/// in      boundary: outer contours of positive area, holes of negative, that neither cross nor touch (nonzero_boundary)
/// cost    O(n sqrt(n)) at worst for edges of similar length
std::vector<TaggedContour> largest_piece(std::vector<TaggedContour> const& boundary);

}  // namespace inkflate
