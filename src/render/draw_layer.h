// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/drawing.h"
#include "render/draw_list.h"

namespace inkflate {

/// One line along each rim, in the colour and width that the layer's outline strokes have on average.
DrawList draw_clean_rims(Drawing const& drawing, Layer const& layer,
                         std::vector<Polyline> const& rims);

/// Strokes as they were drawn. Help lines are no ink.
DrawList draw_ink(Drawing const& drawing, std::vector<int> const& strokes);

}  // namespace inkflate
