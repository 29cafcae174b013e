// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simplify/rim.h"

namespace inkflate {

enum class ClosingShape {
  Flowing,   // goes on in the direction of the strokes, where both ends face each other
  Straight,  // the shortest way
};

struct FitOptions {
  double smooth = 0.5;  // 0 .. 1
  ClosingShape closing = ClosingShape::Flowing;
};

/// Turns a rim into an outline of cubics, in work px: corners stay, all else becomes smooth, a piece never spans two kinds.
///
/// in      rim, with one position per corner of it (centre_rim's, or the samples' own)
/// out     a closed chain of cubics with the rim's kinds and the strokes that drew it. Nothing is promised about crossings
/// cost    O(n log n)
Outline fit_rim(Rim const& rim, Contour const& positions, StrokeSamples const& samples,
                FitOptions const& options);

/// The rim as it is: one straight cubic per edge.
Outline straight_outline(Rim const& rim, StrokeSamples const& samples);

}  // namespace inkflate
