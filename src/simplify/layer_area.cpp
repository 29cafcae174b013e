// SPDX-License-Identifier: Apache-2.0
#include "simplify/layer_area.h"

#include <cmath>

namespace inkflate {
namespace {

// Points on the outline are at most this far apart, work px: half of it is how wrong a distance to the outline may be.
constexpr double kStepPx = 4;

constexpr double kBucketPx = 12;

Contour dense_contour(Outline const& outline, WorkSpace const& space) {
  auto const corners = flatten(outline, 0.5 * space.to_canvas);
  Contour contour;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    auto const a = space.work_point(corners[i]);
    auto const b = space.work_point(corners[(i + 1) % corners.size()]);
    int const steps = static_cast<int>(std::ceil(distance(a, b) / kStepPx));
    for (int k = 0; k < steps; ++k) contour.push_back(lerp(a, b, static_cast<double>(k) / steps));
  }
  return contour;
}

}  // namespace

LayerArea::LayerArea(Layer const& layer, WorkSpace const& space)
    : contour_(dense_contour(layer.outlines.front(), space)),
      box_(bounds(contour_)),
      grid_(contour_, kBucketPx) {}

bool LayerArea::is_in_box(Vec2 p, double margin_px) const {
  return p.x >= box_.min.x - margin_px && p.x <= box_.max.x + margin_px &&
         p.y >= box_.min.y - margin_px && p.y <= box_.max.y + margin_px;
}

bool LayerArea::holds(Vec2 p) const { return is_in_box(p, 0) && contains(contour_, p); }

bool LayerArea::is_at_rim(Vec2 p, double distance_px) const {
  return is_in_box(p, distance_px) && grid_.any_near(p, distance_px, [&](int i) {
    return squared_norm(contour_[i] - p) <= distance_px * distance_px;
  });
}

}  // namespace inkflate
