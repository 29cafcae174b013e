// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"
#include "render/draw_model.h"

namespace inkflate {

/// Darkens a soft ellipse under the model, as wide as it; on a clear picture it is translucent black.
void draw_ground_shadow(DrawTriangles const& list, Picture& picture);

}  // namespace inkflate
