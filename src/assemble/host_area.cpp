// SPDX-License-Identifier: Apache-2.0
#include "assemble/host_area.h"

#include <cmath>
#include <limits>

namespace inkflate {
namespace {

/// Every so many points of a fine contour that steps are about as long as wanted.
Contour thinned(Contour const& fine, double step_px) {
  Contour coarse;
  double since = step_px;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    if (i > 0) since += distance(fine[i - 1], fine[i]);
    if (since < step_px) continue;
    coarse.push_back(fine[i]);
    since = 0;
  }
  return coarse.size() >= 3 ? coarse : fine;
}

}  // namespace

HostArea::HostArea(LayerRim const& rim, double step_px) {
  contours_.push_back(thinned(outer_contour(rim), step_px));
  for (auto const& hole : rim.holes) contours_.push_back(thinned(hole, step_px));
  box_ = bounds(contours_.front());
  area_px2_ = signed_area(contours_.front());
}

double HostArea::clearance(Vec2 p) const {
  double const to_box =
      std::max({box_.min.x - p.x, p.x - box_.max.x, box_.min.y - p.y, p.y - box_.max.y});
  if (to_box > 0) return -to_box;
  double least = std::numeric_limits<double>::infinity();
  for (auto const& contour : contours_) {
    for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
      least = std::min(least, squared_distance_to_segment(p, contour[j], contour[i]));
    }
  }
  double const distance_px = std::sqrt(least);
  return contains(contours_, p) ? distance_px : -distance_px;
}

double HostArea::least_clearance(Polyline const& points, double enough) const {
  double least = std::numeric_limits<double>::infinity();
  for (auto const p : points) {
    least = std::min(least, clearance(p));
    if (least < enough) break;
  }
  return least;
}

}  // namespace inkflate
