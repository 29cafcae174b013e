// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/polyline.h"

namespace inkflate {

/// A closed contour whose edges say where they come from.
struct TaggedContour {
  Contour points;
  std::vector<int> tags;  // one for each point: of the edge that leaves it
};

/// The boundary of the area around which contours wind at all, as contours that neither cross nor touch themselves or one another: outer
/// ones with positive area, holes with negative. What the contours wind around backwards belongs to the area, too.
///
/// in      contours: any finite points, within 1e6 px
/// out     edges keep their tags; of edges that lie on one another the least. Points move by less than 2e-6 of the shapes' size (5e-4 at
///         worst: where lines nearly lie on one another and pieces touch). Pieces of the area that touch in single points are joined
///         there by bridges, up to bridge_px wide; that may close holes off, too. None: not found, which is not known to happen.
///         Empty: nothing is enclosed
/// cost    O((n + k) log n) for k crossings and edges of similar length, and O(n) for each contour
std::optional<std::vector<TaggedContour>> nonzero_boundary(std::span<TaggedContour const> contours,
                                                           double bridge_px);

}  // namespace inkflate
