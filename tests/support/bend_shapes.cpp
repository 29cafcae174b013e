// SPDX-License-Identifier: Apache-2.0
#include "support/bend_shapes.h"

#include <algorithm>
#include <limits>

#include "geometry/trig.h"
#include "support/extremes.h"

namespace inkflate::support {

Outline polygon_outline(Contour const& corners) {
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i)
    outline.pieces.push_back({line_cubic(corners[i], corners[(i + 1) % corners.size()])});
  return outline;
}

Outline disc_outline(Vec2 centre, double radius, bool is_hole) {
  // Leaves the circle by 0.03 % of its radius.
  double const handle = 0.5522847498 * radius;
  double const sense = is_hole ? -1 : 1;
  Outline outline;
  Vec2 out = {1, 0};
  Vec2 along = {0, sense};
  for (int k = 0; k < 4; ++k) {
    Vec2 const a = centre + out * radius;
    Vec2 const b = centre + along * radius;
    outline.pieces.push_back({{{a, a + along * handle, b + out * handle, b}}});
    Vec2 const next = -out;
    out = along;
    along = next;
  }
  // Each starts where the one before ends, to the last bit.
  for (std::size_t k = 0; k < 4; ++k)
    outline.pieces[k].curve.control[3] = outline.pieces[(k + 1) % 4].curve.control[0];
  return outline;
}

Outline bar_outline(double length, double width) {
  return polygon_outline({{0, 0}, {length, 0}, {length, width}, {0, width}});
}

BendShape face_shape(double radius) {
  double const r = radius;
  BendShape shape;
  shape.outlines = {disc_outline({r, r}, r), disc_outline({1.2 * r, 1.4 * r}, 0.2 * r, true)};
  auto& outer = shape.outlines.front();
  outer.pieces[1].kind = RunKind::Closing;
  outer.pieces[2].kind = RunKind::HelpLine;
  outer.sources = {{0, 0.75, 3, 10, 40}, {0.75, 1, 4, 9, 2.5}, {3, 4, 3, 40, 61}};
  Polyline eye;
  for (int k = 0; k <= 24; ++k) {
    auto const turn = sin_cos(2 * kPi * k / 24);
    eye.push_back(Vec2{0.6 * r, 0.7 * r} + Vec2{turn.cos, turn.sin} * (0.1 * r));
  }
  Polyline whisker;
  for (int k = 0; k <= 40; ++k) whisker.push_back({1.5 * r + 0.03 * r * k, 0.8 * r});
  shape.lines = {eye, whisker, {{1.4 * r, 0.7 * r}}};
  return shape;
}

Outline crossing_outline(double size) {
  double const s = size / 10;
  return polygon_outline({{0, 8 * s},
                          {8 * s, 0},
                          {10 * s, 2 * s},
                          {4 * s, 5 * s},
                          {10 * s, 8 * s},
                          {8 * s, 10 * s},
                          {0, 2 * s},
                          {2 * s, 1 * s}});
}

Contour folded_limb_corners() {
  return {{0, 0},    {200, 0},  {200, 140}, {260, 140}, {260, 80},  {120, 80},
          {120, 40}, {300, 40}, {300, 180}, {200, 180}, {200, 200}, {0, 200}};
}

std::function<Vec2(Vec2)> arc_map(double length, double middle, double angle_rad) {
  double const radius = length / angle_rad;
  return [=](Vec2 p) {
    auto const turn = sin_cos(p.x / radius);
    double const own = radius - (p.y - middle);
    return Vec2{own * turn.sin, middle + radius - own * turn.cos};
  };
}

std::function<Vec2(Vec2)> strong_bend(BendShape const& shape) {
  Rect box;
  for (auto const& outline : shape.outlines) {
    for (auto const& piece : outline.pieces) box.include(piece.curve.start());
  }
  return arc_map(box.width(), box.max.y * 1.5, 1.2);
}

Bender made_bender(BendShape const& shape, BendMode mode) {
  BendOptions options;
  options.mode = mode;
  return Bender::make(shape, options).value();
}

BendPose posed(BendPose const& rest, std::function<Vec2(Vec2)> const& map) {
  BendPose pose;
  for (auto const p : rest) pose.push_back(map(p));
  return pose;
}

double least_area(FlatMesh const& mesh, std::vector<Vec2> const& points) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const& t : mesh.triangles) {
    least = smaller(least, cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
  }
  return least;
}

double largest_difference(BendShape const& is, BendShape const& wanted) {
  double const infinite = std::numeric_limits<double>::infinity();
  if (is.outlines.size() != wanted.outlines.size() || is.lines.size() != wanted.lines.size())
    return infinite;
  double largest = 0;
  for (std::size_t i = 0; i < is.outlines.size(); ++i) {
    auto const& a = is.outlines[i].pieces;
    auto const& b = wanted.outlines[i].pieces;
    if (a.size() != b.size()) return infinite;
    for (std::size_t k = 0; k < a.size(); ++k) {
      for (std::size_t c = 0; c < 4; ++c)
        largest = larger(largest, distance(a[k].curve.control[c], b[k].curve.control[c]));
    }
  }
  for (std::size_t i = 0; i < is.lines.size(); ++i) {
    if (is.lines[i].size() != wanted.lines[i].size()) return infinite;
    for (std::size_t k = 0; k < is.lines[i].size(); ++k)
      largest = larger(largest, distance(is.lines[i][k], wanted.lines[i][k]));
  }
  return largest;
}

BendShape mapped(BendShape shape, std::function<Vec2(Vec2)> const& map) {
  for (auto& outline : shape.outlines) {
    for (auto& piece : outline.pieces) {
      for (auto& point : piece.curve.control) point = map(point);
    }
  }
  for (auto& line : shape.lines) {
    for (auto& point : line) point = map(point);
  }
  return shape;
}

}  // namespace inkflate::support
