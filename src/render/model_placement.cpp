// SPDX-License-Identifier: Apache-2.0
#include "render/model_placement.h"

#include <algorithm>

#include "geometry/trig.h"

namespace inkflate {
namespace {

/// The model fills this share of the picture; the rest is margin.
constexpr double kFilledShare = 0.88;

/// Of the depth of the model that lies flat: too little to be seen, enough to tell what hides what.
constexpr double kFlatDepth = 0.01;

/// Height by width of the shadow.
constexpr double kFlatness = 0.11;

struct Box {
  Vec3 min;
  Vec3 max;
};

ModelPlacement seen_from(ModelView const& view) {
  auto const turn = sin_cos(view.turn_rad);
  auto const tilt = sin_cos(view.tilt_rad);
  ModelPlacement result;
  result.to_viewer = {turn.sin * tilt.cos, tilt.sin, turn.cos * tilt.cos};
  result.right = {turn.cos, 0, -turn.sin};
  result.up = cross(result.to_viewer, result.right);
  return result;
}

Box bounds_of(std::vector<Vec3> const& points, ModelPlacement const& placement) {
  if (points.empty()) return {};
  auto const first = placement.turned(points[0]);
  Box box = {first, first};
  for (auto const point : points) {
    auto const p = placement.turned(point);
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  return box;
}

double fitting_scale(Box const& box, double width_px, double height_px) {
  double const scale_x = width_px / std::max(box.max.x - box.min.x, 1e-9);
  double const scale_y = height_px / std::max(box.max.y - box.min.y, 1e-9);
  double const scale = kFilledShare * std::min(scale_x, scale_y);
  return scale < 1e9 * kFilledShare ? scale : 1;  // a model without extent has no fitting scale
}

}  // namespace

ModelPlacement model_placement(RestModel const& model, ModelView const& view, double width_px,
                               double height_px, ModelFit fit) {
  auto result = seen_from(view);
  auto const box = bounds_of(model.mesh.points, result);
  auto const front = seen_from({});
  auto const fitted = fit == ModelFit::AsTurned ? box : bounds_of(model.mesh.points, front);
  result.scale = view.zoom * fitting_scale(fitted, width_px, height_px);
  auto const centre = (fitted.min + fitted.max) / 2;
  result.centre = fit == ModelFit::AsTurned ? centre : result.turned(centre);
  result.pan_px = {view.pan_px.x, -view.pan_px.y};
  if (model.mesh.points.empty()) return result;
  auto const placed = [&](Vec3 corner) {
    auto const p = result.scale * (corner - result.centre);
    return Vec2{p.x, p.y} + result.pan_px;
  };
  result.box.include(placed(box.min));
  result.box.include(placed(box.max));
  return result;
}

SpaceMap to_view(ModelPlacement const& placement, double width_px, double height_px) {
  auto const& [right, up, to_viewer, scale, centre, pan_px, box] = placement;
  return {scale * right.x,     scale * right.y,
          scale * right.z,     width_px / 2 + pan_px.x - scale * centre.x,
          -scale * up.x,       -scale * up.y,
          -scale * up.z,       height_px / 2 - pan_px.y + scale * centre.y,
          scale * to_viewer.x, scale * to_viewer.y,
          scale * to_viewer.z, -scale * centre.z};
}

SpaceMap onto_paper(RestModel const& model, Affine const& canvas_to_view) {
  auto const& map = canvas_to_view;
  auto const origin = map({model.width_px / 2, model.height_px / 2});
  return {map.a,    -map.c, 0,
          origin.x,  //
          map.b,    -map.d, 0,
          origin.y,  //
          0,        0,      kFlatDepth * map.mean_scale(),
          0};
}

ShadowEllipse shadow_ellipse(Rect const& box, double width_px, double height_px) {
  double const radius_px = std::max(0.52 * box.width(), 1e-9);
  // The feet stand in it, not behind it.
  Vec2 const centre = {width_px * 0.5 + box.centre().x,
                       height_px * 0.5 - box.min.y - 0.25 * kFlatness * radius_px};
  return {centre, {radius_px, kFlatness * radius_px}};
}

}  // namespace inkflate
