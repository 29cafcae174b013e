// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/point_grid.h"
#include "model/drawing.h"
#include "simplify/work_space.h"

namespace inkflate {

/// What the outer outline of a layer encloses, to ask where places lie; in work px.
class LayerArea {
 public:
  LayerArea(Layer const& layer, WorkSpace const& space);

  Contour const& contour() const { return contour_; }
  bool holds(Vec2 p) const;
  /// Whether the outline is no farther than this.
  bool is_at_rim(Vec2 p, double distance_px) const;
  /// Whether p lies in the area or no farther from it than this.
  bool covers(Vec2 p, double distance_px) const { return holds(p) || is_at_rim(p, distance_px); }

 private:
  bool is_in_box(Vec2 p, double margin_px) const;

  Contour contour_;  // no edge longer than a few px
  Rect box_;
  PointGrid grid_;
};

}  // namespace inkflate
