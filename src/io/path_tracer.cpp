// SPDX-License-Identifier: Apache-2.0
#include "io/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr double kFlattenTolerancePx = 0.1;
// A cubic over an eighth of a circle misses it by 4e-6 radii, far below the tolerance of flattening.
constexpr double kLargestArcPiece = kPi / 4;

bool is_in_range(Vec2 p) {  // false for NaN too
  return std::abs(p.x) <= kCoordinateLimit && std::abs(p.y) <= kCoordinateLimit;
}

// The ellipse is where frame maps the unit circle.
struct CentreArc {
  Affine frame;
  double from = 0;   // angle on the unit circle
  double sweep = 0;  // signed
};

CentreArc centre_form(Vec2 from, EndpointArc const& arc) {
  double const turn = arc.rotation_degrees - 360 * std::floor(arc.rotation_degrees / 360);
  auto const [s, c] = sin_cos(turn * (kPi / 180));
  Vec2 const middle = (from + arc.to) / 2;
  Vec2 const half = (from - arc.to) / 2;
  Vec2 radii = {std::abs(arc.radii.x), std::abs(arc.radii.y)};
  // On the unit circle the chord's ends are +-h; radii too small to span it grow until it is a diameter.
  Vec2 h = {(c * half.x + s * half.y) / radii.x, (c * half.y - s * half.x) / radii.y};
  double const size = norm(h);
  if (size > 1) {
    radii *= size;
    h = h / size;
  }
  double const offset = std::sqrt(std::max(0.0, 1 - squared_norm(h))) / std::max(norm(h), 1e-300);
  Vec2 const centre = perpendicular(h) * (arc.is_large == arc.is_sweep ? offset : -offset);
  Vec2 const first = h - centre;
  Vec2 const last = -h - centre;
  double sweep = atan2_of(cross(first, last), dot(first, last));
  if (arc.is_sweep && sweep < 0) sweep += 2 * kPi;
  if (!arc.is_sweep && sweep > 0) sweep -= 2 * kPi;
  Affine const stretch = Affine{c * radii.x, s * radii.x, -s * radii.y, c * radii.y, 0, 0};
  return {Affine::translation(middle + stretch(centre)) * stretch, atan2_of(first.y, first.x),
          sweep};
}

}  // namespace

bool PathTracer::accept(Vec2 canvas_point) {
  if (!is_in_range(canvas_point)) fault_ = TraceFault::OutOfRange;
  if (point_count_ >= point_limit_) fault_ = TraceFault::TooManyPoints;
  if (fault_ != TraceFault::None) return false;
  subpaths_.back().push_back(canvas_point);
  ++point_count_;
  return true;
}

// A subpath gets its first point when something is drawn from it, so that mere moves leave nothing.
bool PathTracer::begin_drawing() {
  if (fault_ != TraceFault::None) return false;
  if (is_drawing_) return true;
  is_drawing_ = true;
  is_just_closed_ = false;
  subpaths_.emplace_back();
  return accept(to_canvas_(position_));
}

void PathTracer::draw(Cubic const& curve) {
  position_ = curve.end();
  Cubic on_canvas;
  for (std::size_t i = 0; i < 4; ++i) {
    on_canvas.control[i] = to_canvas_(curve.control[i]);
    if (!is_in_range(on_canvas.control[i])) fault_ = TraceFault::OutOfRange;
  }
  if (fault_ != TraceFault::None) return;
  int const count = flatten_count(on_canvas, kFlattenTolerancePx);
  for (int i = 1; i < count; ++i) {
    if (!accept(point_at(on_canvas, static_cast<double>(i) / count))) return;
  }
  accept(on_canvas.end());
}

void PathTracer::move_to(Vec2 to) {
  position_ = start_ = to;
  is_drawing_ = false;
  is_just_closed_ = false;
}

void PathTracer::line_to(Vec2 to) {
  if (!begin_drawing()) return;
  position_ = to;
  accept(to_canvas_(to));
}

void PathTracer::cubic_to(Vec2 control1, Vec2 control2, Vec2 to) {
  if (begin_drawing()) draw({{position_, control1, control2, to}});
}

void PathTracer::arc_to(EndpointArc const& arc) {
  if (arc.radii.x == 0 || arc.radii.y == 0) return line_to(arc.to);
  if (arc.to == position_ || !begin_drawing()) return;
  auto const [frame, from, sweep] = centre_form(position_, arc);
  if (!std::isfinite(sweep)) {
    fault_ = TraceFault::OutOfRange;
    return;
  }
  int const count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / kLargestArcPiece)));
  double const step = sweep / count;
  auto const [s, c] = sin_cos(step / 4);
  double const handle = 4.0 / 3 * s / c;
  for (int i = 0; i < count; ++i) {
    auto const a = sin_cos(from + i * step);
    auto const b = sin_cos(from + (i + 1) * step);
    Vec2 const first = {a.cos, a.sin};
    Vec2 const last = {b.cos, b.sin};
    draw({{position_, frame(first + perpendicular(first) * handle),
           frame(last - perpendicular(last) * handle), i + 1 < count ? frame(last) : arc.to}});
  }
}

void PathTracer::close() {
  if (is_just_closed_) return;
  if (begin_drawing()) {
    auto const& subpath = subpaths_.back();
    if (subpath.size() < 2 || subpath.back() != subpath.front()) accept(Vec2(subpath.front()));
  }
  move_to(start_);
  is_just_closed_ = true;
}

void PathTracer::ellipse(Vec2 centre, Vec2 radii) {
  Vec2 const right = centre + Vec2{radii.x, 0};
  move_to(right);
  arc_to({radii, 0, false, true, centre - Vec2{radii.x, 0}});
  arc_to({radii, 0, false, true, right});
  close();
}

std::vector<Polyline> PathTracer::take_subpaths() {
  is_drawing_ = false;
  return std::exchange(subpaths_, {});
}

}  // namespace inkflate
