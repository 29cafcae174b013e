// SPDX-License-Identifier: Apache-2.0
#include "deform/strip_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace inkflate {
namespace {

// Strips are 6 % of the shape wide: half of that, and a line turns twice as sharply where a hand bends it.
constexpr double kHalfWidthShare = 0.03;
constexpr double kMostSpineEdges = 199;
// Where a spine turns by more than 60 degrees its sides get points of their own for both edges.
constexpr double kSharpCosine = 0.5;
// How much of an edge the side of a bend may take away at each of its ends.
constexpr double kShareOfEdge = 0.25;
// A strip is no wider than this many of its edges: with the bounds above all its triangles are positive up to 1.3.
constexpr double kHalfWidthEdges = 1.25;
// No strip is narrower: at 1e6 px doubles hold its triangles well.
constexpr double kLeastHalfWidthPx = 1e-3;
// Of the half width: a line shorter than this is a dot, and points of a spine that are closer are one.
constexpr double kDotShare = 0.01;

/// The two sides of a spine: towards perpendicular(edge), and away from it.
enum Side : int { Right = 0, Left = 1 };

/// What the edges before and after a spine's vertex have on one side of it: the same point, but at sharp corners.
struct SidePoints {
  int before = -1;
  int after = -1;
};

class StripMaker {
 public:
  StripMaker(ShapeMesh& shape, LineSamples const& line, double half_width_px)
      : mesh_(shape.mesh.rest), line_(line), half_width_px_(half_width_px) {
    count_ = static_cast<int>(std::ssize(line.points));
    first_ = static_cast<int>(std::ssize(mesh_.points));
    mesh_.points.insert(mesh_.points.end(), line.points.begin(), line.points.end());
    edges_ = line.is_closed ? count_ : count_ - 1;
    for (int i = 0; i < edges_; ++i) {
      Vec2 const edge = line.points[(i + 1) % count_] - line.points[i];
      lengths_.push_back(norm(edge));
      tangents_.push_back(edge / lengths_.back());
    }
  }

  void run() {
    for (auto& side : sides_) side.resize(static_cast<std::size_t>(count_));
    for (int v = 0; v < count_; ++v) add_sides(v);
    for (int i = 0; i < edges_; ++i) {
      add_cells(i, Right);
      add_cells(i, Left);
    }
  }

 private:
  int add_point(int v, Vec2 direction, double width) {
    mesh_.points.push_back(line_.points[v] + direction * width);
    return static_cast<int>(std::ssize(mesh_.points)) - 1;
  }

  void add_sides(int v) {
    bool const is_start = !line_.is_closed && v == 0;
    bool const is_end = !line_.is_closed && v == count_ - 1;
    int const before = is_start ? v : (v + edges_ - 1) % edges_;
    int const after = is_end ? before : v;
    Vec2 const in = tangents_[before];
    Vec2 const out = tangents_[after];
    double const cosine = dot(in, out);
    double const shorter = std::min(lengths_[before], lengths_[after]);
    double width = std::min(half_width_px_, kHalfWidthEdges * shorter);
    if (cosine < kSharpCosine) {
      add_corner(v, in, out, width);
      return;
    }
    double const half_sine = std::sqrt(std::max(0.0, (1 - cosine) / 2));
    double const room = kShareOfEdge * shorter;
    if (width * half_sine > room) width = room / half_sine;
    Vec2 const across = perpendicular(normalized(in + out));
    int const right = add_point(v, across, width);
    int const left = add_point(v, -across, width);
    sides_[Right][v] = {right, right};
    sides_[Left][v] = {left, left};
  }

  /// The inner sides of both edges lie over each other; a wedge of two triangles joins the outer ones.
  void add_corner(int v, Vec2 in, Vec2 out, double width) {
    for (Side const side : {Right, Left}) {
      double const sign = side == Right ? 1 : -1;
      sides_[side][v].before = add_point(v, sign * perpendicular(in), width);
      sides_[side][v].after = add_point(v, sign * perpendicular(out), width);
    }
    int const tip = add_point(v, normalized(in - out), width);
    // A spine that turns towards its right is open on its left.
    bool const is_left = cross(in, out) >= 0;
    auto const& outer = sides_[is_left ? Left : Right][v];
    add_triangle(first_ + v, outer.before, tip, is_left);
    add_triangle(first_ + v, tip, outer.after, is_left);
  }

  /// is_forward: a, b, c go around as positive areas do.
  void add_triangle(int a, int b, int c, bool is_forward) {
    mesh_.triangles.push_back(is_forward ? Triangle{a, b, c} : Triangle{a, c, b});
  }

  double area(int a, int b, int c) const {
    return cross(mesh_.points[b] - mesh_.points[a], mesh_.points[c] - mesh_.points[a]);
  }

  /// Two triangles on one side of an edge, cut along the diagonal that leaves the larger ones.
  void add_cells(int i, Side side) {
    int const next = (i + 1) % count_;
    int const a = first_ + i;
    int const b = first_ + next;
    int const c = sides_[side][next].before;
    int const d = sides_[side][i].after;
    bool const is_right = side == Right;
    double const sign = is_right ? 1 : -1;
    double const over_ac = std::min(sign * area(a, b, c), sign * area(a, c, d));
    double const over_bd = std::min(sign * area(a, b, d), sign * area(b, c, d));
    if (over_ac >= over_bd) {
      add_triangle(a, b, c, is_right);
      add_triangle(a, c, d, is_right);
    } else {
      add_triangle(a, b, d, is_right);
      add_triangle(b, c, d, is_right);
    }
  }

  FlatMesh& mesh_;
  LineSamples const& line_;
  double half_width_px_;
  int count_ = 0;  // of the spine's vertices
  int first_ = 0;  // of them, in the mesh
  int edges_ = 0;
  std::vector<double> lengths_;
  std::vector<Vec2> tangents_;
  std::array<std::vector<SidePoints>, 2> sides_;
};

void finish(ShapeMesh& shape, BendLine line, BendLineOrigin origin) {
  shape.mesh.stiffness.resize(shape.mesh.rest.triangles.size(), 1.0);
  shape.mesh.lines.push_back(std::move(line));
  shape.origins.push_back(std::move(origin));
}

double length_of(LineSamples const& line) {
  return line.is_closed ? perimeter(line.points) : length(line.points);
}

bool is_line(LineSamples const& line, double half_width_px) {
  return line.points.size() >= 2 && length_of(line) > kDotShare * half_width_px;
}

/// Without points that come back to where the one before was.
LineSamples without_returns(LineSamples const& line, double least_px) {
  LineSamples result;
  for (std::size_t k = 0; k < line.points.size(); ++k) {
    auto const& points = result.points;
    if (!points.empty() && !(distance(points.back(), line.points[k]) > least_px)) continue;
    result.points.push_back(line.points[k]);
    result.parameters.push_back(line.parameters[k]);
  }
  if (line.is_closed && result.points.size() > 1 &&
      !(distance(result.points.front(), result.points.back()) > least_px)) {
    result.points.pop_back();
    result.parameters.pop_back();
  }
  result.is_closed = line.is_closed && result.points.size() >= 3;
  return result;
}

/// The line by points as far apart as a spine needs them; fewer than two where it is a dot.
LineSamples spine_of(LineSamples const& line, double half_width_px) {
  if (!is_line(line, half_width_px)) return {};
  std::vector<double> const spacing(line.points.size(),
                                    spine_edge_px(length_of(line), half_width_px));
  bool const is_thinnable = !line.is_closed || line.points.size() >= 3;
  return without_returns(is_thinnable ? thinned(line, spacing) : line, kDotShare * half_width_px);
}

}  // namespace

double strip_half_width_px(double longer_side_px) {
  return longer_side_px > 0 ? std::max(kHalfWidthShare * longer_side_px, kLeastHalfWidthPx) : 1;
}

double spine_edge_px(double length_px, double half_width_px) {
  return std::max(length_px / kMostSpineEdges, half_width_px);
}

void add_strip(ShapeMesh& shape, LineSamples const& line, int origin, double half_width_px) {
  int const first = static_cast<int>(std::ssize(shape.mesh.rest.points));
  StripMaker(shape, line, half_width_px).run();
  BendLine spine;
  spine.is_closed = line.is_closed;
  for (int v = 0; v < std::ssize(line.points); ++v) spine.vertices.push_back(first + v);
  finish(shape, std::move(spine), {origin, line.parameters});
}

void add_dot(ShapeMesh& shape, Vec2 place, int origin, double half_width_px) {
  auto& mesh = shape.mesh.rest;
  int const centre = static_cast<int>(std::ssize(mesh.points));
  double const r = half_width_px;
  for (Vec2 const offset : {Vec2{0, 0}, Vec2{r, 0}, Vec2{0, r}, Vec2{-r, 0}, Vec2{0, -r}})
    mesh.points.push_back(place + offset);
  for (int k = 0; k < 4; ++k)
    mesh.triangles.push_back({centre, centre + 1 + k, centre + 1 + (k + 1) % 4});
  finish(shape, {{centre}, false}, {origin, {0.0}});
}

ShapeMesh strip_mesh(std::span<LineSamples const> lines, double half_width_px) {
  ShapeMesh shape;
  shape.mesh.edge_px = half_width_px;
  for (int i = 0; i < std::ssize(lines); ++i) {
    auto const spine = spine_of(lines[i], half_width_px);
    if (spine.points.size() >= 2) add_strip(shape, spine, i, half_width_px);
  }
  if (!shape.mesh.lines.empty()) return shape;
  for (int i = 0; i < std::ssize(lines); ++i) {
    if (!lines[i].points.empty()) add_dot(shape, lines[i].points.front(), i, half_width_px);
  }
  return shape;
}

}  // namespace inkflate
