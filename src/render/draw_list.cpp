// SPDX-License-Identifier: Apache-2.0
#include "render/draw_list.h"

namespace inkflate {
namespace {

void move_points(std::vector<Vec2>& points, Affine const& map) {
  for (auto& point : points) point = map(point);
}

void scale(std::vector<double>& lengths_px, double factor) {
  for (auto& length_px : lengths_px) length_px *= factor;
}

}  // namespace

DrawList place(DrawList list, Affine const& map) {
  double const factor = map.mean_scale();
  for (auto& item : list) {
    if (auto* const path = std::get_if<FilledPath>(&item)) {
      for (auto& contour : path->contours) move_points(contour, map);
    } else if (auto* const line = std::get_if<StrokedPolyline>(&item)) {
      move_points(line->points, map);
      scale(line->widths_px, factor);
      scale(line->dashes_px, factor);
    } else if (auto* const dots = std::get_if<Dots>(&item)) {
      move_points(dots->centres, map);
      dots->diameter_px *= factor;
    } else if (auto* const drawn = std::get_if<DrawnPicture>(&item)) {
      drawn->map = map * drawn->map;
    }
  }
  return list;
}

void append(DrawList& list, DrawList const& upper) {
  list.insert(list.end(), upper.begin(), upper.end());
}

}  // namespace inkflate
