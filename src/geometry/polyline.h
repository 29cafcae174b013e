// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/rect.h"
#include "geometry/vec2.h"

namespace inkflate {

using Polyline = std::vector<Vec2>;  // open: a point list, joined in order
using Contour = std::vector<Vec2>;   // closed: the last point is joined to the first

Rect bounds(std::span<Vec2 const> points);

/// Length of the open polyline, px.
double length(std::span<Vec2 const> points);
/// Length of the closed contour, px.
double perimeter(std::span<Vec2 const> contour);

/// Shoelace area of a contour, px^2; positive for outer contours in our coordinates (y down).
double signed_area(std::span<Vec2 const> contour);

/// How often a contour winds around p: 1 inside of a simple contour of positive area, -1 inside of one of negative area, 0 outside. Points
/// exactly on the contour may count as on either side. O(n).
int winding_number(std::span<Vec2 const> contour, Vec2 p);
/// The same for several contours together.
int winding_number(std::span<Contour const> contours, Vec2 p);

/// Whether p lies in the area of a contour or of several: where they wind around it at all (non-zero).
bool contains(std::span<Vec2 const> contour, Vec2 p);
bool contains(std::span<Contour const> contours, Vec2 p);

/// The squared distance from p to the segment a b.
double squared_distance_to_segment(Vec2 p, Vec2 a, Vec2 b);

}  // namespace inkflate
