// SPDX-License-Identifier: Apache-2.0
#include "render/draw_model.h"

#include <algorithm>
#include <limits>

#include "geometry/trig.h"

namespace inkflate {
namespace {

/// The model fills this share of the picture; the rest is margin.
constexpr double kFilledShare = 0.88;

/// The directions of the view in the model's space.
struct Axes {
  Vec3 right;
  Vec3 up;
  Vec3 to_viewer;

  Vec3 operator()(Vec3 p) const { return {dot(right, p), dot(up, p), dot(to_viewer, p)}; }
};

Axes axes_of(ModelView const& view) {
  auto const turn = sin_cos(view.turn_rad);
  auto const tilt = sin_cos(view.tilt_rad);
  Axes axes;
  axes.to_viewer = {turn.sin * tilt.cos, tilt.sin, turn.cos * tilt.cos};
  axes.right = {turn.cos, 0, -turn.sin};
  axes.up = cross(axes.to_viewer, axes.right);
  return axes;
}

struct Box {
  Vec3 min;
  Vec3 max;
};

Box bounds_of(std::vector<Vec3> const& points) {
  if (points.empty()) return {};
  Box box = {points[0], points[0]};
  for (auto const p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
}

double fitting_scale(Box const& box, int width, int height) {
  double const scale_x = width / std::max(box.max.x - box.min.x, 1e-9);
  double const scale_y = height / std::max(box.max.y - box.min.y, 1e-9);
  double const scale = kFilledShare * std::min(scale_x, scale_y);
  return scale < 1e9 * kFilledShare ? scale : 1;  // a model without extent has no fitting scale
}

}  // namespace

DrawTriangles draw_model(RestModel const& model, Texture const* texture, ModelView const& view,
                         Shading shading, int width, int height) {
  auto const axes = axes_of(view);
  DrawTriangles list;
  list.triangles = model.mesh.triangles;
  list.shading = shading;
  if (shading == Shading::Textured && texture) {
    list.texture = &texture->picture;
    list.corners = texture->corners;
  }
  for (auto const p : model.mesh.points) list.positions.push_back(axes(p));
  for (auto const n : model.normals) list.normals.push_back(axes(n));
  auto const box = bounds_of(list.positions);
  double const scale = view.zoom * fitting_scale(box, width, height);
  Vec3 const centre = (box.min + box.max) / 2;
  for (auto& p : list.positions) p = scale * (p - centre) + Vec3{view.pan_px.x, -view.pan_px.y, 0};
  return list;
}

}  // namespace inkflate
