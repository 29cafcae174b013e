// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/grid2.h"
#include "render/draw_model.h"

namespace inkflate {

enum class GroundShadow { Off, On };

struct ModelPictureOptions {
  Colour background = {0, 0, 0, 0};
  GroundShadow shadow = GroundShadow::Off;
};

/// Draws triangles with hidden surfaces removed, antialiased (3 x 3 samples for each pixel), without a window or a
/// GPU; the same bytes on every machine.
///
/// in      list: finite; corners, where there are any, as many as triangles. What leaves the picture is cut off
///         width, height: 0 .. 16384
/// cost    O(triangles + pixels): 10,000 triangles on 512 x 512 about 30 ms; memory: the picture and a band of 16 rows
/// source  edge functions on a fixed-point grid: Pineda 1988
Picture rasterise_model(DrawTriangles const& list, int width, int height,
                        ModelPictureOptions const& options = {});

}  // namespace inkflate
