// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/drawing.h"
#include "render/bake_texture.h"
#include "render/draw_list.h"

namespace inkflate {

/// The ink of one layer, in canvas px: its outline, and its details unless they are hidden. Help lines are no ink.
DrawList draw_layer_ink(Drawing const& drawing, Layer const& layer, OutlineLook outline,
                        BackDetails details);

}  // namespace inkflate
