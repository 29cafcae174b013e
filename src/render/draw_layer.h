// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/drawing.h"
#include "render/draw_list.h"
#include "render/layer_rims.h"

namespace inkflate {

/// One line along each rim, in the colour that the layer's outline strokes have on average, and in their width; thinner
/// where the surface is so steep that it would be a belt.
DrawList draw_clean_rims(Drawing const& drawing, Layer const& layer,
                         std::vector<RimLine> const& rims);

/// Strokes as they were drawn. Help lines are no ink.
DrawList draw_ink(Drawing const& drawing, std::vector<int> const& strokes);

}  // namespace inkflate
