// SPDX-License-Identifier: Apache-2.0
#include "editor/view.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

/// The share of the view that a fitted box fills; the rest is margin.
constexpr double kFittedShare = 0.88;

Vec2 half_of(ViewSize const& size) { return {size.width_px / 2, size.height_px / 2}; }

/// A stretch of the screen as one of the canvas at zoom 1.
Vec2 unmirrored(Camera const& camera, Vec2 v) { return camera.is_mirrored ? Vec2{-v.x, v.y} : v; }

Camera centred_at(Camera camera, Vec2 centre) {
  camera.centre = {std::clamp(centre.x, -Camera::kReachPx, Camera::kReachPx),
                   std::clamp(centre.y, -Camera::kReachPx, Camera::kReachPx)};
  return camera;
}

double clamped_zoom(double zoom) {
  return std::clamp(zoom, Camera::kLeastZoom, Camera::kLargestZoom);
}

}  // namespace

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
  // The difference of the two distances to the pointer, not of two places: exact also far from the origin.
  auto const to_pointer = unmirrored(camera, screen - half_of(size));
  return centred_at(next, camera.centre + to_pointer * (1 / camera.zoom - 1 / next.zoom));
}

Camera fitted(Camera const& camera, ViewSize const& size, Rect const& box) {
  if (!is_finite(box.min) || !is_finite(box.max) || box.is_empty()) return camera;
  auto next = camera;
  // A single place has no fitting zoom; it only comes to the middle.
  if (box.longer_side() > 0) {
    next.zoom =
        clamped_zoom(kFittedShare * std::min(size.width_px / std::max(box.width(), 1e-9),
                                             size.height_px / std::max(box.height(), 1e-9)));
  }
  return centred_at(next, box.centre());
}

Camera mirrored(Camera const& camera) {
  auto next = camera;
  next.is_mirrored = !camera.is_mirrored;
  return next;
}

bool is_selected(View const& view, LayerId layer) {
  return std::binary_search(view.selection.begin(), view.selection.end(), layer);
}

}  // namespace inkflate
