// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"
#include "model/drawing.h"

namespace inkflate {

/// The silhouette: 255 where the centre of a pixel lies inside a layer that is shown, where its outlines wind around it at all
/// (non-zero, so holes are outside), else 0. As large as the canvas, rounded up to whole pixels, at most 16384 each way.
Mask draw_mask(Drawing const& drawing);

}  // namespace inkflate
