// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"

namespace inkflate {

/// For each pixel the squared distance from its centre to that of the nearest pixel that is 0 in the mask; the outside
/// of the picture does not count. Exact. Larger than any distance in the picture when no pixel is 0. O(pixels).
/// source  Felzenszwalb and Huttenlocher 2012, lower envelope of parabolas
Grid2<double> squared_distance_to_zero(Mask const& mask);

}  // namespace inkflate
