// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"

namespace inkflate {

enum class Neighbours {
  Four,   // across sides
  Eight,  // across sides and corners
};

/// The connected areas of the pixels that are not 0.
struct Components {
  Grid2<int> labels;             // 0 .. count - 1 in order of first pixel; -1 where the mask is 0
  std::vector<long long> areas;  // px, by label
};

/// O(pixels), without recursion.
Components connected_components(Mask const& mask, Neighbours neighbours);

/// The mask without connected areas (across corners) of fewer pixels.
Mask without_specks(Mask mask, long long smallest_px);

}  // namespace inkflate
