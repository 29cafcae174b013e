// SPDX-License-Identifier: Apache-2.0
#include "editor/screen_shapes.h"

#include <utility>

#include "render/palette.h"

namespace inkflate {
namespace {

constexpr double kRingPx = 1.75;
constexpr double kHaloPx = 1.5;

}  // namespace

StrokedPolyline screen_line(Polyline points, double width_px, Colour colour) {
  return {std::move(points), {width_px}, {}, colour, {width_px, width_px}};
}

Polyline rim(Rect const& box) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}, box.min};
}

void add_ring(DrawList& list, Vec2 centre, double radius_px, Colour colour) {
  list.push_back(Dots{{centre}, 2 * (radius_px + kHaloPx), palette::kHalo});
  list.push_back(Dots{{centre}, 2 * radius_px, colour});
  list.push_back(Dots{{centre}, 2 * (radius_px - kRingPx), palette::kHalo});
}

}  // namespace inkflate
