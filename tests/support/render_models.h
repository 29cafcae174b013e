// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/trig.h"
#include "model/drawing.h"
#include "model/rest_model.h"

namespace inkflate {

/// A ball as inflate would make it of a disc: both sheets in rings around the middle, the rim shared.
struct BallShape {
  Vec2 centre;  // canvas px
  double radius_px = 100;
  double z_px = 0;
  int rings = 32;
  int sectors = 96;
};

/// A model without triangles on a canvas of this size.
inline RestModel empty_model(double width_px, double height_px) {
  RestModel model;
  model.width_px = width_px;
  model.height_px = height_px;
  return model;
}

namespace detail {

/// Ring 0 is the middle of the sheet.
inline int add_ball_vertex(RestModel& model, BallShape const& ball, int ring, int sector,
                           Side side) {
  auto const tilt = sin_cos(kPi / 2 * ring / ball.rings);
  auto const turn = sin_cos(2 * kPi * sector / ball.sectors);
  double const z = ring == ball.rings ? 0 : (side == Side::Front ? tilt.cos : -tilt.cos);
  Vec3 const normal = {tilt.sin * turn.cos, tilt.sin * turn.sin, z};
  Vec3 const centre = {ball.centre.x - model.width_px / 2, model.height_px / 2 - ball.centre.y,
                       ball.z_px};
  model.mesh.points.push_back(centre + ball.radius_px * normal);
  model.normals.push_back(normal);
  model.canvas.push_back(ball.centre + ball.radius_px * Vec2{normal.x, -normal.y});
  return static_cast<int>(std::ssize(model.mesh.points)) - 1;
}

inline void add_ball_triangle(RestModel& model, Face face, int a, int b, int c) {
  if (face.side == Side::Back) std::swap(b, c);
  model.mesh.triangles.push_back({a, b, c});
  model.faces.push_back(face);
}

}  // namespace detail

/// Adds a ball as the model's next layer.
inline void add_ball(RestModel& model, BallShape const& ball) {
  int const layer = static_cast<int>(std::ssize(model.layer_names));
  model.layer_names.push_back("ball " + std::to_string(layer + 1));
  int const rim = static_cast<int>(std::ssize(model.mesh.points));
  for (int i = 0; i < ball.sectors; ++i) {
    detail::add_ball_vertex(model, ball, ball.rings, i, Side::Front);
  }
  for (Side const side : {Side::Front, Side::Back}) {
    int const middle = detail::add_ball_vertex(model, ball, 0, 0, side);
    for (int ring = 1; ring < ball.rings; ++ring) {
      for (int i = 0; i < ball.sectors; ++i) detail::add_ball_vertex(model, ball, ring, i, side);
    }
    auto const vertex = [&](int ring, int sector) {
      int const i = sector % ball.sectors;
      if (ring == 0) return middle;
      return ring == ball.rings ? rim + i : middle + 1 + (ring - 1) * ball.sectors + i;
    };
    for (int ring = 0; ring < ball.rings; ++ring) {
      for (int i = 0; i < ball.sectors; ++i) {
        detail::add_ball_triangle(model, {layer, side}, vertex(ring, i), vertex(ring + 1, i),
                                  vertex(ring + 1, i + 1));
        if (ring == 0) continue;
        detail::add_ball_triangle(model, {layer, side}, vertex(ring, i), vertex(ring + 1, i + 1),
                                  vertex(ring, i + 1));
      }
    }
  }
}

/// A circle of four ink pieces.
inline Outline circle_outline(Vec2 centre, double radius_px) {
  // The distance of the inner control points that keeps a quarter of a circle within 0.03 % of its radius.
  constexpr double handle = 0.5522847498;
  Outline outline;
  Vec2 along = {1, 0};
  for (int i = 0; i < 4; ++i) {
    Vec2 const next = {-along.y, along.x};  // clockwise on the screen: positive area
    Vec2 const from = centre + radius_px * along;
    Vec2 const to = centre + radius_px * next;
    outline.pieces.push_back(
        {Cubic{{from, from + handle * radius_px * next, to + handle * radius_px * along, to}},
         RunKind::Ink});
    along = next;
  }
  outline.pieces.back().curve.control[3] = outline.pieces.front().curve.control[0];
  return outline;
}

/// Adds a layer whose outline is a circle drawn by one stroke.
inline Layer& add_disc(Drawing& drawing, Vec2 centre, double radius_px, Colour ink = {}) {
  Stroke stroke;
  stroke.colour = ink;
  stroke.width_px = 4;
  for (int i = 0; i <= 90; ++i) {
    auto const turn = sin_cos(2 * kPi * i / 90);
    stroke.samples.push_back({centre + radius_px * Vec2{turn.cos, turn.sin}});
  }
  drawing.sketch.strokes.push_back(stroke);
  Layer layer;
  layer.name = "disc " + std::to_string(drawing.layers.size() + 1);
  layer.outlines = {circle_outline(centre, radius_px)};
  layer.strokes = {static_cast<int>(std::ssize(drawing.sketch.strokes)) - 1};
  drawing.layers.push_back(layer);
  return drawing.layers.back();
}

/// Adds a straight stroke as a detail of a layer.
inline void add_detail(Drawing& drawing, int layer, Vec2 from, Vec2 to, Colour ink,
                       double width_px = 6) {
  drawing.sketch.strokes.push_back({{{from}, {to}}, StrokeKind::Ink, width_px, ink});
  drawing.layers[static_cast<std::size_t>(layer)].details.push_back(
      static_cast<int>(std::ssize(drawing.sketch.strokes)) - 1);
}

}  // namespace inkflate
