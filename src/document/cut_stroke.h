// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/polyline.h"
#include "geometry/rect.h"
#include "model/stroke.h"

namespace inkflate {

/// What a round eraser passes over on its way.
class Swept {
 public:
  /// in      path: at least one point, finite; radius_px > 0
  Swept(Polyline path, double radius_px);

  /// False: nothing of what lies in the box is met.
  bool may_meet(Rect const& box) const;

  /// What remains of a stroke; none: the eraser has not met it. Pieces start and end where the eraser's edge crosses the stroke, with
  /// pressure and time as they were there; times are counted from the piece's start. Pieces too short to be seen are left out.
  std::optional<std::vector<Stroke>> cut(Stroke const& stroke) const;

 private:
  /// The eraser between two points of its path.
  struct Capsule {
    Vec2 from;
    Vec2 to;
    Rect box;
  };
  struct Stretch {
    double from = 0;  // 0 .. 1 along a segment
    double to = 0;
  };

  /// Those that may meet something in the box: long ways pass most strokes by.
  std::vector<Capsule> capsules_near(Rect const& box) const;
  Stretch within(Capsule const& capsule, Vec2 a, Vec2 b) const;
  bool covers(std::vector<Capsule> const& capsules, Vec2 p) const;
  /// The stretches of the segment that are erased: ascending, apart.
  std::vector<Stretch> erased(std::vector<Capsule> const& capsules, Vec2 a, Vec2 b) const;

  std::vector<Capsule> capsules_;
  Rect box_;
  double radius_px_ = 0;
  double tolerance_px_ = 0;  // what is less is rounding: ends of pieces lie on the edge
};

}  // namespace inkflate
