// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "assemble/layer_rim.h"
#include "geometry/rect.h"

namespace inkflate {

/// The area of a layer, coarsely: to find out what lies on it and how deep inside.
class HostArea {
 public:
  HostArea(LayerRim const& rim, double step_px);

  /// Within the outer outline, px^2.
  double area() const { return area_px2_; }

  /// Distance to the layer's boundary: positive inside, negative outside. Far outside it is only a lower bound of the distance.
  double clearance(Vec2 p) const;
  /// The least of the points' clearances; stops early once it is below `enough`.
  double least_clearance(Polyline const& points, double enough) const;

 private:
  std::vector<Contour> contours_;
  Rect box_;
  double area_px2_ = 0;
};

}  // namespace inkflate
