// SPDX-License-Identifier: Apache-2.0
#include "deform/motion_field.h"

namespace inkflate {
namespace {

// Where a line turns back so sharply that its neighbours are closer than this share of the way between them, they tell nothing about the
// change along it.
constexpr double kLeastChord = 0.5;

/// a as a column times b as a row, added.
void add_product(Linear2& sum, Vec2 a, Vec2 b) {
  sum.x += a * b.x;
  sum.y += a * b.y;
}

}  // namespace

MotionField::MotionField(BendMesh const& mesh)
    : rest_(&mesh.rest), areas_(mesh.rest.points.size(), 0) {
  auto const& points = mesh.rest.points;
  for (auto const& t : mesh.rest.triangles) {
    double const area = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    for (int const v : t) areas_[v] += area;
  }
  for (auto const& line : mesh.lines) add_line(line);
}

void MotionField::add_line(BendLine const& line) {
  auto const& points = rest_->points;
  int const count = static_cast<int>(std::ssize(line.vertices));
  if (count < 2) return;
  for (int i = 0; i < count; ++i) {
    LineVertex own;
    own.vertex = line.vertices[i];
    own.before = line.is_closed || i > 0 ? line.vertices[(i + count - 1) % count] : own.vertex;
    own.after = line.is_closed || i + 1 < count ? line.vertices[(i + 1) % count] : own.vertex;
    double const way = distance(points[own.before], points[own.vertex]) +
                       distance(points[own.vertex], points[own.after]);
    Vec2 const chord = points[own.after] - points[own.before];
    own.length_px = norm(chord);
    if (!(own.length_px > kLeastChord * way)) continue;
    own.direction = chord / own.length_px;
    line_vertices_.push_back(own);
  }
}

std::vector<VertexMotion> MotionField::motions(std::span<Vec2 const> pose) const {
  auto const& points = rest_->points;
  std::vector<VertexMotion> motions(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) motions[v].shift = pose[v] - points[v];
  for (auto const& t : rest_->triangles) {
    // The gradient of the shift times twice the area.
    Linear2 gradient;
    Vec2 const shift = motions[t[0]].shift;
    add_product(gradient, motions[t[1]].shift - shift, perpendicular(points[t[0]] - points[t[2]]));
    add_product(gradient, motions[t[2]].shift - shift, perpendicular(points[t[1]] - points[t[0]]));
    for (int const v : t) {
      motions[v].change.x += gradient.x;
      motions[v].change.y += gradient.y;
    }
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!(areas_[v] > 0)) continue;
    motions[v].change.x = motions[v].change.x / areas_[v];
    motions[v].change.y = motions[v].change.y / areas_[v];
  }
  for (auto const& own : line_vertices_) {
    auto& change = motions[own.vertex].change;
    Vec2 const along = (motions[own.after].shift - motions[own.before].shift) / own.length_px;
    add_product(change, along - change(own.direction), own.direction);
  }
  return motions;
}

}  // namespace inkflate
