// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/polyline.h"

namespace inkflate {

/// How fine the rim of a region is sampled.
struct RimSpacingOptions {
  double longest_px = 8;        // > 0; where the region is wide
  double shortest_px = 1.5;     // > 0; no edge is meant to be shorter, however thin the region is
  double share_of_width = 0.1;  // > 0; of the region's width at that place
  double growth =
      0.3;  // > 0; px by which the spacing may grow per px along the rim or across the region
};

/// The wanted edge length at each point of a region's contours: short where the region is thin.
///
/// in      contours: the outer one, then the holes; simple, disjoint, sampled more finely than the result is meant to be
/// out     for each contour one length per point, px
/// cost    O(n log n) for contours sampled evenly
std::vector<std::vector<double>> rim_spacing(std::span<Contour const> contours,
                                             RimSpacingOptions const& options = {});

/// Points along a line, about as far apart as wanted there. The first and the last point stay what they are, and so do corners: where
/// the line turns by more than about 30 degrees within one spacing.
///
/// in      line: at least two points; spacing: one length > 0 per point, interpolated between them
/// out     at least two points, and at least four where the line is closed (last == first)
/// cost    O(n)
Polyline resample(std::span<Vec2 const> line, std::span<double const> spacing);

/// A place of a line: so far along the edge that starts at this point. Its last point is a place with the share 0.
struct LinePlace {
  int edge = 0;
  double share = 0;  // 0 .. 1 of the edge
};

/// The same by where the points lie.
std::vector<LinePlace> resample_places(std::span<Vec2 const> line, std::span<double const> spacing);

}  // namespace inkflate
