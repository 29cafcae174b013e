// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/cubic.h"

namespace inkflate {

/// A cubic that stands for the points first .. last of the fitted polyline.
struct FittedCubic {
  Cubic curve;
  int first = 0;
  int last = 0;
};

/// Fits smoothly joined cubics (common tangents) to a polyline: as few as a greedy split gives.
///
/// in      points: at least two, consecutive ones distinct; tolerance > 0
///         start_tangent, end_tangent: directions of travel at both ends, length 1
/// out     a chain from the first point to the last, exactly; every point within tolerance of its cubic at the parameter
///         found for it, which bounds the distance from above. Between the points nothing is promised
/// cost    O(n log n) typically
/// source  Schneider 1990, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems
std::vector<FittedCubic> fit_cubics(std::span<Vec2 const> points, Vec2 start_tangent,
                                    Vec2 end_tangent, double tolerance);

}  // namespace inkflate
