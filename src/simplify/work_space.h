// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/rect.h"
#include "geometry/vec2.h"
#include "mesh/delaunay.h"

namespace inkflate {

/// The working space of simplify: every sketch is scaled so that the longer side of its strokes is kSizePx long. So all lengths
/// below mean the same on a thumbnail and on a poster. The lattice of the triangulation has kLatticePerPx points in a work px.
struct WorkSpace {
  static constexpr double kSizePx = 1000;
  static constexpr int kLatticePerPx = 16;
  static constexpr double kMarginPx = 12;  // keeps rounded points on the lattice
  // Canvas px. Of coordinates up to 1e6 too few digits are left below it to tell points of the lattice apart.
  static constexpr double kLeastSidePx = 1e-4;

  Vec2 origin;           // canvas px: goes to (kMarginPx, kMarginPx)
  double to_work = 1;    // work px per canvas px
  double to_canvas = 1;  // canvas px per work px

  /// box: of all strokes, in canvas px. A single point, or what is hardly more, gets a space in which it is the corner.
  static WorkSpace around(Rect const& box) {
    WorkSpace space;
    if (box.is_empty()) return space;
    space.origin = box.min;
    if (box.longer_side() >= kLeastSidePx) {
      space.to_work = kSizePx / box.longer_side();
      space.to_canvas = box.longer_side() / kSizePx;
    }
    return space;
  }

  Vec2 work_point(Vec2 canvas) const {
    return (canvas - origin) * to_work + Vec2{kMarginPx, kMarginPx};
  }
  Vec2 canvas_point(Vec2 work) const {
    return (work - Vec2{kMarginPx, kMarginPx}) * to_canvas + origin;
  }

  /// p in work px, within the space and its margin.
  static LatticePoint lattice_point(Vec2 p) {
    return {static_cast<int>(std::floor(p.x * kLatticePerPx + 0.5)),
            static_cast<int>(std::floor(p.y * kLatticePerPx + 0.5))};
  }
  /// Work px; exact.
  static Vec2 lattice_position(LatticePoint p) {
    return Vec2{static_cast<double>(p.x), static_cast<double>(p.y)} / kLatticePerPx;
  }
};
static_assert((WorkSpace::kSizePx + 2 * WorkSpace::kMarginPx) * WorkSpace::kLatticePerPx <=
              kLatticeSize);

}  // namespace inkflate
