// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simplify/stroke_samples.h"

namespace inkflate {

/// An end of a stroke beyond which the drawing does not go on.
struct LooseEnd {
  int sample = 0;        // its own, the first or last one of the stroke
  int back = 1;          // from there to the stroke's next sample: 1 or -1
  double length_px = 0;  // of its stroke, work px

  friend bool operator==(LooseEnd const&, LooseEnd const&) = default;
};

/// Finds the ends of ink strokes that no other sample follows: none ahead of them, and no help line beside them. Of strokes drawn over one
/// another only those ends are loose that reach farthest.
///
/// in      samples: drawn ones, of strokes of the sketch
/// out     in stroke order; none of strokes that are hardly more than dots
/// cost    O(samples)
std::vector<LooseEnd> loose_ends(Sketch const& sketch, StrokeSamples const& samples);

}  // namespace inkflate
