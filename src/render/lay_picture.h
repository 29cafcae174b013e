// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "geometry/affine.h"
#include "image/grid2.h"

namespace inkflate {

/// Where a template lies: from px of the picture to px of the canvas, as large as fits and centred. At least one pixel; sides of the
/// canvas > 0.
inline Affine lay_picture(Picture const& picture, double canvas_width_px, double canvas_height_px) {
  double const scale = std::min(canvas_width_px / picture.width, canvas_height_px / picture.height);
  return {scale,
          0,
          0,
          scale,
          (canvas_width_px - picture.width * scale) / 2,
          (canvas_height_px - picture.height * scale) / 2};
}

}  // namespace inkflate
