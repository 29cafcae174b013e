// SPDX-License-Identifier: Apache-2.0
#include "editor/view.h"

#include <algorithm>
#include <cmath>

#include "document/apply.h"
#include "geometry/trig.h"

namespace inkflate {
namespace {

/// The share of the view that a fitted box fills; the rest is margin.
constexpr double kFittedShare = 0.88;

/// How far the middle of the model may lie from the middle of the view: at its largest it is as far across.
constexpr double kModelReachPx = 1e5;

Vec2 half_of(ViewSize const& size) { return {size.width_px / 2, size.height_px / 2}; }

/// A stretch of the screen as one of the canvas at zoom 1.
Vec2 unmirrored(Camera const& camera, Vec2 v) { return camera.is_mirrored ? Vec2{-v.x, v.y} : v; }

Camera centred_at(Camera camera, Vec2 centre) {
  double const reach_px = DocumentLimits::kFarthestPx;
  camera.centre = {std::clamp(centre.x, -reach_px, reach_px),
                   std::clamp(centre.y, -reach_px, reach_px)};
  return camera;
}

ModelView moved_to(ModelView model, Vec2 pan_px) {
  model.pan_px = {std::clamp(pan_px.x, -kModelReachPx, kModelReachPx),
                  std::clamp(pan_px.y, -kModelReachPx, kModelReachPx)};
  return model;
}

struct Span {
  double from_px = 0;
  double to_px = 0;
};

/// What two edges leave of a length: at least half of it, with the edges as one to the other.
Span free_of(double first_px, double last_px, double length_px) {
  double const share = std::min(1.0, length_px / 2 / std::max(first_px + last_px, 1e-9));
  return {share * first_px, length_px - share * last_px};
}

/// Where the middle of a length comes to lie that needs so much of the free span: as near to the wish as the span allows.
double placed_in(double from_px, double to_px, double needed_px, double wish_px) {
  double const middle_px = (from_px + to_px) / 2;
  double const slack_px = std::max(0.0, (to_px - from_px - needed_px) / 2);
  return middle_px + std::clamp(wish_px - middle_px, -slack_px, slack_px);
}

double clamped_zoom(double zoom) {
  return std::clamp(zoom, Camera::kLeastZoom, Camera::kLargestZoom);
}

}  // namespace

Rect free_room(ViewSize const& size) {
  auto const& edges = size.edges;
  auto const [left_px, right_px] = free_of(edges.left_px, edges.right_px, size.width_px);
  auto const [top_px, bottom_px] = free_of(edges.top_px, edges.bottom_px, size.height_px);
  return {{left_px, top_px}, {right_px, bottom_px}};
}

double free_height_px(ViewSize const& size) {
  return std::max(size.height_px - 2 * size.edges.top_px, size.height_px / 2);
}

Affine canvas_to_screen(Camera const& camera, ViewSize const& size) {
  double const scale_x = camera.is_mirrored ? -camera.zoom : camera.zoom;
  auto const half = half_of(size);
  return {scale_x,
          0,
          0,
          camera.zoom,
          half.x - scale_x * camera.centre.x,
          half.y - camera.zoom * camera.centre.y};
}

Vec2 to_canvas(Camera const& camera, ViewSize const& size, Vec2 screen) {
  return camera.centre + unmirrored(camera, screen - half_of(size)) / camera.zoom;
}

Camera panned(Camera const& camera, Vec2 screen_delta) {
  if (!is_finite(screen_delta)) return camera;
  return centred_at(camera, camera.centre - unmirrored(camera, screen_delta) / camera.zoom);
}

Camera zoomed(Camera const& camera, ViewSize const& size, Vec2 screen, double factor) {
  if (!is_finite(screen) || !std::isfinite(factor) || factor <= 0) return camera;
  auto next = camera;
  next.zoom = clamped_zoom(camera.zoom * factor);
  // The difference of the two distances to the pointer, not of two places: exact far from the origin too.
  auto const to_pointer = unmirrored(camera, screen - half_of(size));
  return centred_at(next, camera.centre + to_pointer * (1 / camera.zoom - 1 / next.zoom));
}

Camera fitted(Camera const& camera, ViewSize const& size, Rect const& box) {
  if (!is_finite(box.min) || !is_finite(box.max) || box.is_empty()) return camera;
  auto next = camera;
  auto const room = free_room(size);
  // A single place has no fitting zoom; it only comes to the middle.
  if (box.longer_side() > 0) {
    next.zoom = clamped_zoom(kFittedShare * std::min(room.width() / std::max(box.width(), 1e-9),
                                                     room.height() / std::max(box.height(), 1e-9)));
  }
  double const per_px = next.zoom / kFittedShare;
  auto const middle = half_of(size);
  Vec2 const at = {placed_in(room.min.x, room.max.x, per_px * box.width(), middle.x),
                   placed_in(room.min.y, room.max.y, per_px * box.height(), middle.y)};
  return centred_at(next, box.centre() - unmirrored(next, at - middle) / next.zoom);
}

Camera mirrored(Camera const& camera) {
  auto next = camera;
  next.is_mirrored = !camera.is_mirrored;
  return next;
}

ModelView turned(ModelView const& model, double turn_rad, double tilt_rad) {
  if (!std::isfinite(turn_rad) || !std::isfinite(tilt_rad)) return model;
  auto next = model;
  double const turn = model.turn_rad + turn_rad;
  next.turn_rad = turn - 2 * kPi * std::floor(turn / (2 * kPi) + 0.5);
  next.tilt_rad = std::clamp(model.tilt_rad + tilt_rad, -kPi / 2, kPi / 2);
  return next;
}

ModelView panned(ModelView const& model, Vec2 screen_delta) {
  if (!is_finite(screen_delta)) return model;
  return moved_to(model, model.pan_px + screen_delta);
}

ModelView zoomed(ModelView const& model, ViewSize const& size, Vec2 screen, double factor) {
  if (!is_finite(screen) || !std::isfinite(factor) || factor <= 0) return model;
  auto next = model;
  next.zoom = std::clamp(model.zoom * factor, kLeastModelZoom, kLargestModelZoom);
  auto const pointer = screen - half_of(size);
  return moved_to(next, pointer + (model.pan_px - pointer) * (next.zoom / model.zoom));
}

bool is_selected(View const& view, LayerId layer) {
  return std::binary_search(view.selection.begin(), view.selection.end(), layer);
}

}  // namespace inkflate
