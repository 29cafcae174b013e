// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/vec2.h"
#include "image/grid2.h"

namespace inkflate {

/// Collects the pixels that the segments of one line cover. Keep one for a whole picture: its cost is that of the
/// pixels touched, not of the picture.
///
/// The share of a pixel is taken from the distance of its centre to the segment, as if the border were straight and
/// parallel to the pixel's side: within 0.06 of the area for widths over 1 px.
class StrokeCoverage {
 public:
  StrokeCoverage(int width, int height);

  /// A segment with round ends whose width runs evenly from one end to the other; all values finite.
  void add_segment(Vec2 a, double width_a_px, Vec2 b, double width_b_px);

  /// Calls paint(x, y, share) once for each pixel touched, in order of first touch, and forgets them.
  template <typename Paint>
  void flush(Paint const& paint) {
    for (int const index : touched_) {
      auto& share = shares_.values[static_cast<std::size_t>(index)];
      paint(index % shares_.width, index / shares_.width, static_cast<double>(share));
      share = 0;
    }
    touched_.clear();
  }

 private:
  Grid2<float> shares_;
  std::vector<int> touched_;
};

}  // namespace inkflate
