// SPDX-License-Identifier: Apache-2.0
#include "pipeline/place_sketch.h"

#include <algorithm>

#include "geometry/affine.h"
#include "geometry/rect.h"

namespace inkflate {
namespace {

// Leaves 7 % of margin on each side: room for outlines that run outside of the pen's middle line.
constexpr double kFitShare = 0.86;

Rect stroke_bounds(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    if (stroke.samples.size() < 2) continue;
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return box;
}

Affine fit_map(Rect const& box, double size_px) {
  if (box.is_empty()) return {};
  double const side_px = box.longer_side();
  double const scale = side_px > 0 ? kFitShare * size_px / side_px : 1;
  // The centre is taken first, so that a far away drawing loses no digits.
  return Affine::translation({size_px / 2, size_px / 2}) * Affine::scaling(scale, scale) *
         Affine::translation(-box.centre());
}

Sketch transformed(Sketch const& sketch, Affine const& map) {
  Sketch placed = sketch;
  for (auto& stroke : placed.strokes) {
    stroke.width_px *= map.mean_scale();
    for (auto& sample : stroke.samples) sample.position = map(sample.position);
  }
  return placed;
}

}  // namespace

Result<Sketch> place_sketch(Sketch const& sketch, PlaceOptions const& options) {
  double const own_px = std::max(sketch.width_px, sketch.height_px);
  double const size_px = options.size_px.value_or(own_px);
  if (options.size_px && !(size_px >= 1 && size_px <= PlaceOptions::kMaxSizePx)) {
    return Error{ErrorCode::BadOption, "the size of the canvas has to be 1 to 16384 px"};
  }
  if (options.mode == PlaceMode::FitStrokes) {
    Sketch placed = transformed(sketch, fit_map(stroke_bounds(sketch), size_px));
    placed.width_px = size_px;
    placed.height_px = size_px;
    return placed;
  }
  if (!options.size_px) return sketch;
  if (!(own_px > 0)) {
    return Error{ErrorCode::NothingThere,
                 "the canvas has no size to scale; fit the strokes instead"};
  }
  double const scale = size_px / own_px;
  Sketch placed = transformed(sketch, Affine::scaling(scale, scale));
  placed.width_px = sketch.width_px * scale;
  placed.height_px = sketch.height_px * scale;
  return placed;
}

}  // namespace inkflate
