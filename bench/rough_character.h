// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/stroke.h"

namespace inkflate {

/// A rough drawing to measure on: a figure with head, arms and legs whose outline is gone over in overlapping strokes, with
/// creases, loops and hatching inside and a few flecks beside it. 20 to 40 samples per stroke.
///
/// in      stroke_count: at least 20. About half of them, but no more than six times round, draw the outline; with
///         more strokes it is the inner detail that grows, as it does when somebody draws on
/// out     a canvas of size_px; the longer side of the strokes is 0.86 of it. The same bits for the same arguments on every
///         machine
Sketch rough_character(int stroke_count, double size_px = 1024, std::uint64_t seed = 1);

}  // namespace inkflate
