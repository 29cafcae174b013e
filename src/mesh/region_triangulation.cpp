// SPDX-License-Identifier: Apache-2.0
#include "mesh/region_triangulation.h"

#include <cmath>
#include <string>

namespace inkflate {
namespace {

constexpr double kFarthestPx = 1e6;
// Smaller numbers would lose bits where the predicates multiply them.
constexpr double kLeastCoordinatePx = 1e-50;

/// A contour or seam within the row of all points.
struct Line {
  int first;
  int count;
  bool is_seam;
  int index;  // among the contours or among the seams

  int edge_count() const { return is_seam ? count - 1 : count; }
  int start(int edge) const { return first + edge; }
  int end(int edge) const { return first + (edge + 1) % count; }
};

std::string name_of(Line const& line) {
  if (line.is_seam) return "seam " + std::to_string(line.index);
  return line.index == 0 ? "the outline" : "hole " + std::to_string(line.index);
}

Error bad_line(Line const& line, std::string const& what) {
  return {ErrorCode::BadInput, name_of(line) + " of the region " + what, line.index};
}

bool is_in_range(double x) {
  return std::abs(x) <= kFarthestPx && (x == 0 || std::abs(x) >= kLeastCoordinatePx);
}

struct Input {
  std::vector<Vec2> points;
  std::vector<Line> lines;

  void add(std::vector<Vec2> const& line, bool is_seam, int index) {
    int const first = static_cast<int>(points.size());
    lines.push_back({first, static_cast<int>(line.size()), is_seam, index});
    points.insert(points.end(), line.begin(), line.end());
  }
  Line const& line_of(int point) const {
    std::size_t i = 0;
    while (point >= lines[i].first + lines[i].count) ++i;
    return lines[i];
  }
};

Result<Input> gather(std::span<Contour const> contours, std::span<Polyline const> seams) {
  Input input;
  for (int i = 0; i < std::ssize(contours); ++i) input.add(contours[i], false, i);
  for (int i = 0; i < std::ssize(seams); ++i) input.add(seams[i], true, i);
  if (contours.empty()) return Error{ErrorCode::BadInput, "the region has no outline"};
  for (auto const& line : input.lines) {
    if (line.count < (line.is_seam ? 2 : 3)) return bad_line(line, "has too few points");
  }
  for (int i = 0; i < std::ssize(input.points); ++i) {
    if (!is_in_range(input.points[i].x) || !is_in_range(input.points[i].y))
      return bad_line(input.line_of(i), "has a point that is not finite or too far away");
  }
  return input;
}

std::optional<Error> fix_lines(Input const& input, DynamicTriangulation& triangles) {
  for (auto const& line : input.lines) {
    auto const kind = line.is_seam ? EdgeKind::Seam : EdgeKind::Rim;
    for (int i = 0; i < line.edge_count(); ++i) {
      auto const fix = triangles.fix_edge(line.start(i), line.end(i), kind);
      if (fix == DynamicTriangulation::Fix::Crosses)
        return bad_line(line, "crosses itself or another line");
      if (fix == DynamicTriangulation::Fix::Touches)
        return bad_line(line, "touches itself or another line");
    }
  }
  return std::nullopt;
}

/// Per triangle how many contours lie around it, up to 3.
std::vector<std::uint8_t> depths(DynamicTriangulation const& triangles) {
  constexpr std::uint8_t unseen = 255;
  std::vector<std::uint8_t> depth(static_cast<std::size_t>(triangles.triangle_count()), unseen);
  std::vector<int> beyond = {triangles.outer_triangle()};
  for (std::uint8_t level = 0; level <= 3 && !beyond.empty(); ++level) {
    std::vector<int> open;
    open.swap(beyond);
    while (!open.empty()) {
      int const t = open.back();
      open.pop_back();
      if (depth[t] != unseen) continue;
      depth[t] = level;
      for (int e = 3 * t; e < 3 * t + 3; ++e) {
        int const other = triangles.twin(e) < 0 ? t : triangles.twin(e) / 3;
        if (depth[other] != unseen) continue;
        (triangles.kind(e) == EdgeKind::Rim ? beyond : open).push_back(other);
      }
    }
  }
  return depth;
}

/// The contours lie in each other as they must, and the seams in the region.
std::optional<Error> check_nesting(Input const& input, DynamicTriangulation const& triangles,
                                   std::vector<std::uint8_t> const& depth) {
  for (auto const& line : input.lines) {
    int const e = triangles.find_edge(line.start(0), line.end(0));
    int const outer = std::min(depth[e / 3], depth[triangles.twin(e) / 3]);
    int const wanted = line.is_seam || line.index > 0 ? 1 : 0;
    if (outer != wanted) return bad_line(line, "does not lie inside the outline");
  }
  return std::nullopt;
}

}  // namespace

Result<RegionTriangulation> triangulate_region(std::span<Contour const> contours,
                                               std::span<Polyline const> seams) {
  auto const input = gather(contours, seams);
  if (!input) return input.error();
  DynamicTriangulation triangles(input->points);
  if (auto const twice = triangles.insert_all())
    return bad_line(input->line_of(*twice), "touches itself or another line");
  if (auto error = fix_lines(*input, triangles)) return *error;
  triangles.make_delaunay();
  auto depth = depths(triangles);
  if (auto error = check_nesting(*input, triangles, depth)) return *error;
  for (auto& level : depth) level = level == 1 ? 1 : 0;
  return RegionTriangulation{std::move(triangles), std::move(depth)};
}

}  // namespace inkflate
