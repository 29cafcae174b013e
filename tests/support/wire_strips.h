// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "deform/wire_strip.h"
#include "geometry/trig.h"

namespace inkflate::support {

inline Vec2 turned(Vec2 p, double angle_rad) {
  auto const [sin, cos] = sin_cos(angle_rad);
  return {cos * p.x - sin * p.y, sin * p.x + cos * p.y};
}

/// A bean: no symmetry, curved both ways.
inline Contour bean(int count, Vec2 centre = {}) {
  Contour contour;
  for (int i = 0; i < count; ++i) {
    double const angle_rad = 2 * kPi * i / count;
    double const radius_px =
        100 + 25 * sin_cos(2 * angle_rad).cos + 10 * sin_cos(3 * angle_rad).sin;
    contour.push_back(centre + turned({radius_px, 0}, angle_rad));
  }
  return contour;
}

inline BendMesh bean_strip() {
  std::vector<Contour> const contours = {bean(40)};
  return wire_strip(contours, 8);
}

inline Vec2 at(BendAnchor const& anchor, BendMesh const& mesh, BendPose const& pose) {
  Vec2 sum;
  for (int k = 0; k < 3; ++k)
    sum += pose[mesh.rest.triangles[anchor.triangle][k]] * anchor.weights[k];
  return sum;
}

/// A handle at the middle of a triangle, moved from its rest.
inline BendHandle moved(BendMesh const& mesh, int triangle, Vec2 by) {
  BendAnchor const anchor = {triangle, {0.5, 0.2, 0.3}};
  return {anchor, at(anchor, mesh, mesh.rest.points) + by};
}

inline std::vector<BendHandle> three_handles(BendMesh const& mesh) {
  return {moved(mesh, 0, {}), moved(mesh, 13, {60, 20}), moved(mesh, 27, {-5, 30})};
}

inline double largest_distance(BendPose const& a, BendPose const& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, distance(a[i], b[i]));
  return largest;
}

}  // namespace inkflate::support
