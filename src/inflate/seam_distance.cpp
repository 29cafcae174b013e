// SPDX-License-Identifier: Apache-2.0
#include "inflate/seam_distance.h"

#include <cmath>
#include <limits>

#include "geometry/segment.h"

namespace inkflate {

SeamPlace nearest_on_seam(std::span<Vec2 const> line, Vec2 p) {
  SeamPlace best;
  double least = std::numeric_limits<double>::infinity();
  int const last_edge = static_cast<int>(std::ssize(line)) - 2;
  for (int e = 0; e <= last_edge; ++e) {
    auto const along = line[e + 1] - line[e];
    double const t = share_along(p, line[e], line[e + 1]);
    double const squared = squared_norm(p - (line[e] + along * t));
    if (squared >= least) continue;
    least = squared;
    bool const is_beyond = (e == 0 && t == 0) || (e == last_edge && t == 1);
    best = {0, e, t, is_beyond ? 0 : cross(along, p - line[e])};
  }
  best.distance_px = std::sqrt(least);
  return best;
}

}  // namespace inkflate
