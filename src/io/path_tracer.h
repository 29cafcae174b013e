// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/affine.h"
#include "geometry/cubic.h"
#include "geometry/polyline.h"
#include "io/sketch_limits.h"

namespace inkflate {

/// Why a trace was given up; what was drawn until then is dropped.
enum class TraceFault { None, OutOfRange, TooManyPoints };

/// An elliptical arc as in a path's A command.
struct EndpointArc {
  Vec2 radii;
  double rotation_degrees = 0;
  bool is_large = false;
  bool is_sweep = false;
  Vec2 to;
};

/// Draws lines and curves in user space into polylines on the canvas, one per subpath. Chords stay within 0.1 px of the
/// curve. After a fault further drawing does nothing.
class PathTracer {
 public:
  PathTracer(Affine const& to_canvas, int point_limit)
      : to_canvas_(to_canvas), point_limit_(point_limit) {}

  void move_to(Vec2 to);
  void line_to(Vec2 to);
  void cubic_to(Vec2 control1, Vec2 control2, Vec2 to);
  /// source  SVG 1.1, implementation note F.6
  void arc_to(EndpointArc const& arc);
  /// Back to the subpath's start, whose canvas point is repeated exactly.
  void close();
  /// A whole ellipse from its rightmost point, closed.
  void ellipse(Vec2 centre, Vec2 radii);

  Vec2 position() const { return position_; }
  TraceFault fault() const { return fault_; }
  /// The subpaths, without those that only move.
  std::vector<Polyline> take_subpaths();

 private:
  void draw(Cubic const& user_space_curve);
  bool begin_drawing();
  bool accept(Vec2 canvas_point);

  Affine to_canvas_;
  int point_limit_ = 0;
  int point_count_ = 0;
  TraceFault fault_ = TraceFault::None;
  Vec2 position_;
  Vec2 start_;
  bool is_drawing_ = false;      // the current subpath has its first point in subpaths_
  bool is_just_closed_ = false;  // closing again would draw a dot
  std::vector<Polyline> subpaths_;
};

}  // namespace inkflate
