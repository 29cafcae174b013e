// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simplify/rim.h"

namespace inkflate {

/// Takes off the parts of a rim that are nowhere wider than width_px: strokes that stick out, drawn once or twice, and fans of cells
/// between them. The rest of the rim is untouched; the cut across a whisker's foot is ink.
///
/// in      rim: simple; width_px > 0, work px
/// out     a simple rim, empty when nothing of the rim is wider
/// cost    O(n log n)
Rim prune_whiskers(Rim const& rim, StrokeSamples const& samples, double width_px);

}  // namespace inkflate
