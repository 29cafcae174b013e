// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "editor/pick.h"
#include "geometry/affine.h"

namespace inkflate {
namespace {

constexpr double kHandleReachPx = 10;
// Far enough from the top handle that a finger holds the right one.
constexpr double kTurnHandleAbovePx = 28;
// Below it, the handles of opposite sides leave less than their own size between them.
constexpr double kSmallBoxPx = 4 * kHandleReachPx;

/// A handle's place on the box: 0 the least, 1 the largest coordinate.
struct HandlePlace {
  FrameHandle handle;
  double x;
  double y;
};

constexpr std::array kPlaces = {
    HandlePlace{FrameHandle::TopLeft, 0, 0},  HandlePlace{FrameHandle::Top, 0.5, 0},
    HandlePlace{FrameHandle::TopRight, 1, 0}, HandlePlace{FrameHandle::Left, 0, 0.5},
    HandlePlace{FrameHandle::Right, 1, 0.5},  HandlePlace{FrameHandle::BottomLeft, 0, 1},
    HandlePlace{FrameHandle::Bottom, 0.5, 1}, HandlePlace{FrameHandle::BottomRight, 1, 1},
};

}  // namespace

std::optional<Frame> selection_frame(Document const& document, View const& view) {
  auto const box = box_of(document, pickable(document, view.selection));
  if (box.is_empty()) return std::nullopt;
  auto const to_screen = canvas_to_screen(view.camera, view.size);
  Frame frame = {box, {}};
  for (auto const& place : kPlaces) {
    Vec2 const canvas = {box.min.x + place.x * box.width(), box.min.y + place.y * box.height()};
    frame.handles.push_back({place.handle, to_screen(canvas)});
  }
  auto const top = to_screen({box.centre().x, box.min.y});
  frame.handles.push_back({FrameHandle::Turn, top - Vec2{0, kTurnHandleAbovePx}});
  return frame;
}

std::optional<FrameHandle> pick_handle(Frame const& frame, View const& view, Vec2 screen) {
  auto const to_screen = canvas_to_screen(view.camera, view.size);
  Rect box;
  box.include(to_screen(frame.box.min));
  box.include(to_screen(frame.box.max));
  bool const is_inside = contains(box, screen);
  bool const is_small = std::min(box.width(), box.height()) < kSmallBoxPx;
  if (is_inside && is_small) return FrameHandle::Inside;
  std::optional<FrameHandle> nearest;
  double least = kHandleReachPx * kHandleReachPx;
  for (auto const& [handle, place] : frame.handles) {
    double const size = squared_norm(place - screen);
    if (size > least) continue;
    least = size;
    nearest = handle;
  }
  if (nearest) return nearest;
  if (is_inside) return FrameHandle::Inside;
  return std::nullopt;
}

}  // namespace inkflate
