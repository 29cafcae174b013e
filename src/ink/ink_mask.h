// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"

namespace inkflate {

/// Where the ink is, as lines only.
struct InkMask {
  Mask lines;  // 255: ink; solid areas are hollowed to a rim of the pen's width
  Grid2<double>
      radius_px;  // distance from a pixel's centre to the nearest paper's border; 0 on paper
};

/// strength: 0 paper .. 255. sheet: where to look at the values, 255. threshold_share: of Otsu's threshold. No ink: an empty mask of the same size.
InkMask find_ink(Mask const& strength, Mask const& sheet, double threshold_share);

}  // namespace inkflate
