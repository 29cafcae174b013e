// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "geometry/polyline.h"
#include "simplify/simplify.h"

namespace inkflate {

/// What a sketch encloses, not yet fitted.
struct QuickShape {
  std::vector<Contour> contours;   // canvas px
  std::vector<int> areas;          // per contour: its group, counted from 0
  std::vector<Polyline> closings;  // those of their stretches that bridge gaps
};

/// A quick look at what simplify by method cut would make: the same stages up to the middle of the strokes, but no curves are fitted
/// and no strokes are sorted. Above kQuickSamples samples it is made of fewer ones, so that small gaps may turn out otherwise; limbs stay
/// open towards other groups.
///
/// in      as of simplify; options: method is not looked at
/// out     contours that may cross themselves where two sides nearly touch
/// errors  those of simplify
/// cost    O(n log n); about 6 ms for 250 strokes and for 1000, 11 ms for 4000
Result<QuickShape> quick_shape(Sketch const& sketch, SimplifyOptions const& options = {},
                               Progress const& progress = {});

/// Of one group. Nearly all drawings have less.
inline constexpr int kQuickSamples = 10'000;

}  // namespace inkflate
