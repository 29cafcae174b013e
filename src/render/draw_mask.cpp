// SPDX-License-Identifier: Apache-2.0
#include "render/draw_mask.h"

#include <algorithm>
#include <cmath>

#include "image/fill_polygon.h"

namespace inkflate {
namespace {

constexpr double kLargestSidePx = 16384;
/// Far below the half pixel that decides; the curve itself is not known better.
constexpr double kFlattenTolerancePx = 0.01;

int canvas_side(double side_px) {
  return static_cast<int>(std::clamp(std::ceil(side_px), 0.0, kLargestSidePx));
}

}  // namespace

Mask draw_mask(Drawing const& drawing) {
  Mask mask(canvas_side(drawing.sketch.width_px), canvas_side(drawing.sketch.height_px));
  for (auto const& layer : drawing.layers) {
    if (!is_shown(layer)) continue;
    std::vector<Contour> contours;
    for (auto const& outline : layer.outlines) {
      contours.push_back(flatten(outline, kFlattenTolerancePx));
    }
    fill_polygon(contours, mask);
  }
  return mask;
}

}  // namespace inkflate
