// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec2.h"
#include "image/grid2.h"
#include "render/model_light.h"

namespace inkflate {

/// The colour at a place of the picture (u to the right, v down, 0 .. 1; beyond it the border goes on), between the
/// four nearest texels; alpha counts as opaque.
Rgb sample_texture(Picture const& picture, Vec2 place);

}  // namespace inkflate
