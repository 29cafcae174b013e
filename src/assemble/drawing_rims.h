// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assemble/layer_rim.h"

namespace inkflate {

/// A thousandth of the drawing's size, so that small and large canvases give the same meshes; 0 where all outlines are one point.
///
/// in      drawing: every layer has an outline of at least one piece
double drawing_unit(Drawing const& drawing);

/// The boundaries of all layers, as finely sampled as joints and meshes need them.
///
/// in      drawing: as above; unit_px: its drawing_unit, > 0
std::vector<LayerRim> drawing_rims(Drawing const& drawing, double unit_px);

}  // namespace inkflate
