// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simplify/stroke_samples.h"

namespace inkflate {

/// Leaves out samples that lie by another one: where a drawing was gone over many times, few of them tell all.
///
/// in      samples: drawn ones, of strokes of the sketch; distance_px > 0, work px
/// out     of the same kind of stroke no two samples nearer than that; all others had one so near. The spacing is that much larger, so
///         what was joined by ink still is, but for gaps as wide
/// cost    O(samples)
StrokeSamples thin_samples(Sketch const& sketch, StrokeSamples const& samples, double distance_px);

}  // namespace inkflate
