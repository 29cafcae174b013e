// SPDX-License-Identifier: Apache-2.0
#include "io/print_pose.h"

#include <algorithm>

namespace inkflate {

TriMesh print_pose(TriMesh const& model, double longest_mm) {
  if (model.points.empty()) return model;
  Vec3 low = model.points.front();
  Vec3 high = low;
  for (auto const p : model.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  double const longest_px = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  double const mm_per_px = longest_px > 0 ? longest_mm / longest_px : 1;
  Vec3 const foot = {(low.x + high.x) / 2, low.y, (low.z + high.z) / 2};
  TriMesh posed = model;
  for (auto& point : posed.points) {
    Vec3 const p = (point - foot) * mm_per_px;
    point = {p.x, -p.z, p.y};
  }
  return posed;
}

}  // namespace inkflate
