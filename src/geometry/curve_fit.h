// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
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

/// One cubic from the first point to the last, with any tangents: for the sides between two corners.
///
/// in      as fit_cubics
/// out     none if the points were not within tolerance of one after a few steps, or if there are fewer than four points
/// cost    O(n)
std::optional<Cubic> fit_one_cubic(std::span<Vec2 const> points, double tolerance);

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
