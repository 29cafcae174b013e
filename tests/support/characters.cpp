// SPDX-License-Identifier: Apache-2.0
#include "support/characters.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr double kStepPx = 4;

void add_line(Outline& outline, Vec2 to, RunKind kind, Vec2 from) {
  outline.pieces.push_back({line_cubic(from, to), kind});
}

/// Joins the points and closes the outline with a piece of the given kind.
Outline outline_of(Polyline const& points, RunKind closing) {
  Outline outline;
  for (std::size_t i = 1; i < points.size(); ++i) {
    add_line(outline, points[i], RunKind::Ink, points[i - 1]);
  }
  add_line(outline, points.front(), closing, points.back());
  return outline;
}

/// Points on a circle from one angle to another, both ends included.
void add_arc(Polyline& points, Vec2 centre, double radius, double from_rad, double to_rad) {
  int const steps = std::max(2, static_cast<int>(std::abs(to_rad - from_rad) * radius / kStepPx));
  for (int k = 0; k <= steps; ++k) {
    auto const turn = sin_cos(from_rad + (to_rad - from_rad) * k / steps);
    points.push_back(centre + Vec2{turn.cos, turn.sin} * radius);
  }
}

}  // namespace

Layer drawn_layer(std::string name, Contour const& points) {
  return {std::move(name), {outline_of(points, RunKind::Ink)}, {}, {}};
}

Contour ellipse_contour(Vec2 centre, double radius_x, double radius_y) {
  int const count =
      std::max(12, static_cast<int>(2 * kPi * std::max(radius_x, radius_y) / kStepPx));
  Contour contour;
  for (int k = 0; k < count; ++k) {
    auto const turn = sin_cos(2 * kPi * k / count);
    contour.push_back(centre + Vec2{turn.cos * radius_x, turn.sin * radius_y});
  }
  return contour;
}

Layer limb_layer(std::string name, Vec2 from, Vec2 to, double half_width_px, RunKind mouth) {
  auto const along = to - from;
  double const angle = atan2_of(along.y, along.x);
  auto const aside = perpendicular(normalized(along)) * half_width_px;
  Polyline points = {from - aside};
  add_arc(points, to, half_width_px, angle - kPi / 2, angle + kPi / 2);
  points.push_back(from + aside);
  return {std::move(name), {outline_of(points, mouth)}, {}, {}};
}

Layer half_ring_layer(std::string name, Vec2 centre, double inner_px, double outer_px,
                      bool is_above) {
  double const start = is_above ? -kPi : 0;
  Polyline points;
  add_arc(points, centre, outer_px, start, start + kPi);
  std::size_t const turn = points.size();
  add_arc(points, centre, inner_px, start + kPi, start);
  auto outline = outline_of(points, RunKind::Closing);
  outline.pieces[turn - 1].kind = RunKind::Closing;
  return {std::move(name), {outline}, {}, {}};
}

Layer ring_layer(std::string name, Vec2 centre, double inner_px, double outer_px) {
  auto hole = ellipse_contour(centre, inner_px, inner_px);
  std::reverse(hole.begin(), hole.end());
  auto layer = drawn_layer(std::move(name), ellipse_contour(centre, outer_px, outer_px));
  layer.outlines.push_back(outline_of(hole, RunKind::Ink));
  return layer;
}

Drawing drawing_of(std::vector<Layer> layers) {
  Drawing drawing;
  drawing.sketch.width_px = 1000;
  drawing.sketch.height_px = 1000;
  drawing.layers = std::move(layers);
  return drawing;
}

Drawing character(int layers) {
  Vec2 const centre = {500, 450};
  auto body = drawn_layer("body", ellipse_contour(centre, 210, 300));
  if (layers <= 1) return drawing_of({std::move(body)});
  if (layers <= 5) {
    auto const left = limb_layer("left arm", {400, 480}, {160, 720}, 55);
    auto const right = limb_layer("right leg", {580, 610}, {640, 900}, 65);
    std::vector<Layer> all;
    if (layers == 5) all = {left, right};
    for (auto& layer : all) layer.name += " behind";
    all.insert(all.end(), {body, left, right});
    return drawing_of(std::move(all));
  }
  std::vector<Layer> behind;
  std::vector<Layer> before;
  int const limbs = layers - 1;
  for (int k = 0; k < limbs; ++k) {
    auto const turn = sin_cos(2 * kPi * k / limbs);
    Vec2 const out = {turn.cos, turn.sin};
    Vec2 const from = centre + Vec2{out.x * 130, out.y * 210};
    Vec2 const to = centre + Vec2{out.x * 420, out.y * 440};
    auto limb = limb_layer("limb " + std::to_string(k + 1), from, to, 18);
    (k % 2 == 0 ? before : behind).push_back(std::move(limb));
  }
  behind.push_back(std::move(body));
  behind.insert(behind.end(), before.begin(), before.end());
  return drawing_of(std::move(behind));
}

}  // namespace inkflate
