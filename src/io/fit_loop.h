// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/polyline.h"
#include "model/drawing.h"

namespace inkflate {

/// How a loop of pixels becomes an outline; each way is safer against crossings than the one before.
enum class LoopFit {
  Smooth,  // averaged, then few cubics
  Tight,   // cubics close to the pixels
  Steps,   // straight from pixel to pixel
};

/// Turns a loop of pixel centres into an outline of cubics: corners stay, all else becomes smooth, a piece never spans two kinds.
///
/// in      loop: at least three distinct points, neighbours at most a pixel apart (simple_loops, image/trace_contour.h)
///         kinds: per point that of the way to the next one
/// out     a closed chain. Nothing is promised about crossings, but that Steps has none
/// cost    O(n log n)
Outline fit_loop(Contour const& loop, std::span<RunKind const> kinds, LoopFit fit);

}  // namespace inkflate
