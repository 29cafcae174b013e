// SPDX-License-Identifier: Apache-2.0
#include "simplify/grid_outline.h"

#include <algorithm>
#include <cstdint>

namespace inkflate {
namespace {

/// The points first ... last of a loop, seen as the line from first to last.
struct Line {
  int loop = 0;
  int first = 0;
  int last = 0;  // may be the number of points: the loop's start
  RunKind kind = RunKind::Ink;
};

Vec2 point_of(Contour const& loop, int index) { return loop[index < std::ssize(loop) ? index : 0]; }
Vec2 start_of(std::span<Contour const> loops, Line const& line) {
  return point_of(loops[line.loop], line.first);
}
Vec2 end_of(std::span<Contour const> loops, Line const& line) {
  return point_of(loops[line.loop], line.last);
}

void split_loop(std::span<Contour const> loops, int loop, Mask const& help_lines,
                double min_line_length_px, std::vector<Line>& lines) {
  auto const& points = loops[loop];
  int const count = static_cast<int>(std::ssize(points));
  Line line = {loop, 0, 0, RunKind::Ink};
  double length_px = 0;
  for (int i = 1; i <= count; ++i) {
    auto const p = point_of(points, i);
    length_px += distance(points[i - 1], p);
    if (help_lines.at(static_cast<int>(p.x), static_cast<int>(p.y)) != 0) {
      line.kind = RunKind::HelpLine;
    }
    if (length_px <= min_line_length_px && i < count) continue;
    line.last = i;
    lines.push_back(line);
    line = {loop, i, i, RunKind::Ink};
    length_px = 0;
  }
}

/// Whether c and d lie on different sides of the line a b, or one of them on it. Exact: the coordinates are halves.
bool separates(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return cross(b - a, c - a) * cross(b - a, d - a) <= 0;
}

/// Whether two segments have more in common than one end of both.
bool are_in_conflict(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (a == d) std::swap(c, d);
  if (b == c) {
    std::swap(a, b);
  } else if (b == d) {
    std::swap(a, b);
    std::swap(c, d);
  }
  if (a == c) return cross(b - a, d - a) == 0 && dot(b - a, d - a) > 0;
  bool const boxes_meet =
      std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
      std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
  return boxes_meet && separates(a, b, c, d) && separates(c, d, a, b);
}

/// Per line whether it meets another one; by a sweep over x.
std::vector<std::uint8_t> find_conflicts(std::span<Contour const> loops,
                                         std::vector<Line> const& lines) {
  struct Extent {
    double min_x = 0;
    double max_x = 0;
    int line = 0;
  };
  std::vector<Extent> extents;
  for (int i = 0; i < std::ssize(lines); ++i) {
    auto const a = start_of(loops, lines[i]);
    auto const b = end_of(loops, lines[i]);
    extents.push_back({std::min(a.x, b.x), std::max(a.x, b.x), i});
  }
  std::sort(extents.begin(), extents.end(), [](Extent const& a, Extent const& b) {
    return a.min_x != b.min_x ? a.min_x < b.min_x : a.line < b.line;
  });
  std::vector<std::uint8_t> has_conflict(lines.size(), 0);
  for (std::size_t i = 0; i < extents.size(); ++i) {
    auto const& line = lines[extents[i].line];
    auto const a = start_of(loops, line);
    auto const b = end_of(loops, line);
    if (a == b) has_conflict[extents[i].line] = 1;  // the whole loop in one line
    for (std::size_t j = i + 1; j < extents.size() && extents[j].min_x <= extents[i].max_x; ++j) {
      auto const& other = lines[extents[j].line];
      if (!are_in_conflict(a, b, start_of(loops, other), end_of(loops, other))) continue;
      has_conflict[extents[i].line] = 1;
      has_conflict[extents[j].line] = 1;
    }
  }
  return has_conflict;
}

/// The lines with those in conflict replaced by single steps.
std::vector<Line> refined(std::vector<Line> const& lines,
                          std::vector<std::uint8_t> const& has_conflict) {
  std::vector<Line> result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto line = lines[i];
    int const last = line.last;
    if (has_conflict[i] != 0) line.last = line.first + 1;
    for (; line.last < last; ++line.first, ++line.last) result.push_back(line);
    result.push_back(line);
  }
  return result;
}

}  // namespace

std::vector<Outline> outlines_of(std::span<Contour const> loops, Mask const& help_lines,
                                 double min_line_length_px) {
  std::vector<Line> lines;
  for (int loop = 0; loop < std::ssize(loops); ++loop) {
    split_loop(loops, loop, help_lines, min_line_length_px, lines);
  }
  // Ends because every round but the last makes more lines, and there are only so many steps.
  for (std::size_t count = 0; count != lines.size();) {
    count = lines.size();
    lines = refined(lines, find_conflicts(loops, lines));
  }
  std::vector<Outline> outlines(loops.size());
  for (auto const& line : lines) {
    outlines[line.loop].pieces.push_back(
        {line_cubic(start_of(loops, line), end_of(loops, line)), line.kind});
  }
  return outlines;
}

}  // namespace inkflate
