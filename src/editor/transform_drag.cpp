// SPDX-License-Identifier: Apache-2.0
#include "editor/transform_drag.h"

#include <algorithm>
#include <cmath>

#include "document/apply.h"
#include "editor/turn_step.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

// Smaller factors lose digits that a later growth would show.
constexpr double kLeastFactor = 0.01;
constexpr double kLeastSidePx = 1;

/// Which side of an axis a handle holds: -1 the least, 1 the largest coordinate, 0 none.
struct HeldSides {
  int x = 0;
  int y = 0;
};

HeldSides held_sides(FrameHandle handle) {
  switch (handle) {
    case FrameHandle::Left:
      return {-1, 0};
    case FrameHandle::Right:
      return {1, 0};
    case FrameHandle::Top:
      return {0, -1};
    case FrameHandle::Bottom:
      return {0, 1};
    case FrameHandle::TopLeft:
      return {-1, -1};
    case FrameHandle::TopRight:
      return {1, -1};
    case FrameHandle::BottomLeft:
      return {-1, 1};
    case FrameHandle::BottomRight:
      return {1, 1};
    case FrameHandle::Inside:
    case FrameHandle::Turn:
      break;
  }
  return {};
}

Affine about(Vec2 fixed, Affine const& map) {
  auto const moved = map(fixed);
  return Affine::translation(fixed - moved) * map;
}

Affine move_map(Vec2 delta, bool is_one_axis) {
  if (is_one_axis) (std::abs(delta.x) >= std::abs(delta.y) ? delta.y : delta.x) = 0;
  return Affine::translation(delta);
}

Affine turn_map(Rect const& box, Vec2 from, Vec2 to, bool is_stepped) {
  auto const a = from - box.centre();
  auto const b = to - box.centre();
  double angle = atan2_of(b.y, b.x) - atan2_of(a.y, a.x);
  if (is_stepped) angle = kTurnStepRad * std::round(angle / kTurnStepRad);
  auto const turn = sin_cos(angle);
  return about(box.centre(), {turn.cos, turn.sin, -turn.sin, turn.cos, 0, 0});
}

/// The factor along one axis by which a held side that lies `side` from the fixed line goes along with the pointer.
double factor(double side, double delta, double size) {
  if (side == 0) return 1;
  double const wanted = (side + delta) / side;
  double const least = std::min(1.0, std::max(kLeastFactor, kLeastSidePx / size));
  return std::abs(wanted) >= least ? wanted : std::copysign(least, wanted);
}

Affine scale_map(ToolTransforming const& drag, ToolPointer const& now) {
  auto const held = held_sides(drag.handle);
  auto const& box = drag.box;
  // From the middle to the held side, and back again to what stays: the other side, or with Alt the middle.
  Vec2 const half = {held.x * box.width() / 2, held.y * box.height() / 2};
  bool const is_centred = now.modifiers.is_alt;
  auto const fixed = is_centred ? box.centre() : box.centre() - half;
  auto const side = is_centred ? half : half * 2;
  auto const delta = now.canvas - drag.from.canvas;
  Vec2 scale = {factor(side.x, delta.x, box.width()), factor(side.y, delta.y, box.height())};
  if (now.modifiers.is_shift) {
    // The axis that goes farther decides; an axis that is not held follows without being mirrored.
    bool const is_x = held.y == 0 || (held.x != 0 && std::abs(scale.x) >= std::abs(scale.y));
    double const size = std::abs(is_x ? scale.x : scale.y);
    scale = {held.x == 0 ? size : std::copysign(size, scale.x),
             held.y == 0 ? size : std::copysign(size, scale.y)};
  }
  return about(fixed, Affine::scaling(scale.x, scale.y));
}

bool is_within_reach(Vec2 p) {
  double const far = DocumentLimits::kFarthestPx;
  return std::abs(p.x) <= far && std::abs(p.y) <= far;
}

}  // namespace

std::optional<Affine> drag_map(ToolTransforming const& drag, ToolPointer const& now) {
  bool const is_shift = now.modifiers.is_shift;
  Affine map;
  if (drag.handle == FrameHandle::Inside) {
    map = move_map(now.canvas - drag.from.canvas, is_shift);
  } else if (drag.handle == FrameHandle::Turn) {
    map = turn_map(drag.box, drag.from.canvas, now.canvas, is_shift);
  } else {
    map = scale_map(drag, now);
  }
  for (Vec2 const corner : {drag.box.min, drag.box.max, Vec2{drag.box.min.x, drag.box.max.y},
                            Vec2{drag.box.max.x, drag.box.min.y}}) {
    if (!is_within_reach(map(corner))) return std::nullopt;
  }
  return map;
}

}  // namespace inkflate
