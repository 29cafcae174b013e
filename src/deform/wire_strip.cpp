// SPDX-License-Identifier: Apache-2.0
#include "deform/wire_strip.h"

#include <utility>

namespace inkflate {
namespace {

// A line turns back on itself where the sum of two unit normals is shorter than this.
constexpr double kHairpin = 1e-9;

/// A line with as many segments as it has.
struct Line {
  std::span<Vec2 const> points;
  bool is_closed = false;

  int point_count() const { return static_cast<int>(std::ssize(points)); }
  int segment_count() const {
    if (point_count() < 2) return 0;
    return is_closed ? point_count() : point_count() - 1;
  }
  int next(int point) const { return point + 1 < point_count() ? point + 1 : 0; }
  double length_px() const { return is_closed ? perimeter(points) : length(points); }
};

/// The unit normal of each segment; one without length takes that of the segment before it, those at the start that of the first
/// with a length.
std::vector<Vec2> segment_normals(Line const& line) {
  std::vector<Vec2> normals;
  for (int i = 0; i < line.segment_count(); ++i) {
    auto const along = normalized(line.points[line.next(i)] - line.points[i]);
    auto const above = -perpendicular(along);
    bool const is_short = along == Vec2{};
    normals.push_back(is_short && !normals.empty() ? normals.back() : above);
  }
  Vec2 first = {0, -1};
  for (auto const& normal : normals) {
    if (normal == Vec2{}) continue;
    first = normal;
    break;
  }
  for (auto& normal : normals) {
    if (normal != Vec2{}) break;
    normal = first;
  }
  return normals;
}

/// d of each point, at length 1.
std::vector<Vec2> point_normals(Line const& line) {
  auto const normals = segment_normals(line);
  if (normals.empty()) return std::vector<Vec2>(line.points.size(), Vec2{0, -1});
  std::vector<Vec2> result;
  for (int i = 0; i < line.point_count(); ++i) {
    bool const is_start = !line.is_closed && i == 0;
    bool const is_end = !line.is_closed && i == line.segment_count();
    Vec2 const after = is_end ? normals.back() : normals[i];
    Vec2 const before = is_start ? after : (i > 0 ? normals[i - 1] : normals.back());
    Vec2 const sum = before + after;
    result.push_back(norm(sum) > kHairpin ? normalized(sum) : after);
  }
  return result;
}

void add_triangle(BendMesh& mesh, int a, int b, int c) {
  auto const& p = mesh.rest.points;
  if (cross(p[b] - p[a], p[c] - p[a]) < 0) std::swap(b, c);
  mesh.rest.triangles.push_back({a, b, c});
}

void add_triangles(BendMesh& mesh, Line const& line, int first) {
  int const s = line.point_count();
  int const segments = line.segment_count();
  auto const i = [first](int k) { return first + k; };
  for (int k = 0; k < segments; ++k) add_triangle(mesh, i(k), i(k) + s, i(line.next(k)));
  for (int k = 0; k < segments; ++k)
    add_triangle(mesh, i(k) + s, i(line.next(k)), i(line.next(k)) + s);
  for (int k = 0; k < segments; ++k)
    add_triangle(mesh, i(k), i(k) + 2 * s, i(line.next(k)) + 2 * s);
  for (int k = 0; k < segments; ++k)
    add_triangle(mesh, i(k), i(line.next(k)), i(line.next(k)) + 2 * s);
}

void add_line(BendMesh& mesh, Line const& line, double half_width_px) {
  int const first = static_cast<int>(mesh.rest.points.size());
  auto const normals = point_normals(line);
  for (double const side : {0.0, half_width_px, -half_width_px}) {
    for (int i = 0; i < line.point_count(); ++i)
      mesh.rest.points.push_back(line.points[i] + normals[i] * side);
  }
  add_triangles(mesh, line, first);
  BendLine bend_line = {{}, line.is_closed};
  for (int i = 0; i < line.point_count(); ++i) bend_line.vertices.push_back(first + i);
  mesh.lines.push_back(std::move(bend_line));
}

BendMesh strip_of(std::span<std::vector<Vec2> const> lines, bool is_closed, double half_width_px) {
  BendMesh mesh;
  double length_px = 0;
  int segments = 0;
  for (auto const& points : lines) {
    Line const line = {points, is_closed};
    length_px += line.length_px();
    segments += line.segment_count();
    double const own_px = line.length_px() > 0 ? line.length_px() / line.segment_count() : 1;
    add_line(mesh, line, half_width_px > 0 ? half_width_px : own_px);
  }
  mesh.stiffness.assign(mesh.rest.triangles.size(), 1);
  mesh.edge_px = length_px > 0 ? length_px / segments : 1;
  return mesh;
}

}  // namespace

BendMesh wire_strip(std::span<Contour const> contours, double half_width_px) {
  return strip_of(contours, true, half_width_px);
}

BendMesh open_wire_strip(std::span<Polyline const> lines, double half_width_px) {
  return strip_of(lines, false, half_width_px);
}

}  // namespace inkflate
