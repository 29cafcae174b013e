// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyline.h"
#include "geometry/rect.h"
#include "model/drawing.h"

namespace inkflate {

/// The area of a layer as polygons: where they wind around at all (non-zero).
struct LayerShape {
  std::vector<Contour> contours;  // canvas px
  Rect box;
};

/// cost    O(pieces of the outlines)
LayerShape layer_shape(Layer const& layer);

/// A box around the outlines that may be a little too large.
/// cost    a fraction of layer_shape's: to see first whether that is needed
Rect loose_box(Layer const& layer);

bool contains(LayerShape const& shape, Vec2 p);

/// Whether the rim comes within reach_px of a place.
bool is_rim_near(LayerShape const& shape, Vec2 p, double reach_px);

/// Whether the areas have a point in common.
/// cost    O(edges where their boxes meet, of the one times of the other)
bool overlap(LayerShape const& a, LayerShape const& b);

}  // namespace inkflate
