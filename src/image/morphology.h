// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"

namespace inkflate {

/// Erosion and dilation by the square of 3 x 3 pixels. Around the mask everything is background: erosion clears
/// the outermost pixels. Values are 0 and 255.
///
/// cost    O(pixels), a few operations on bytes each
/// source  thesis section 5.4.2
Mask erode_3x3(Mask const& mask);
Mask dilate_3x3(Mask const& mask);

}  // namespace inkflate
