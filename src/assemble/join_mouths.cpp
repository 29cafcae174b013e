// SPDX-License-Identifier: Apache-2.0
#include "assemble/join_mouths.h"

#include <algorithm>
#include <cmath>

#include "geometry/crossings.h"

namespace inkflate {
namespace {

// How far apart the ends of two mouths may lie, as a share of the smaller mouth.
constexpr double kReachShare = 0.35;
// Mouths look at each other within 60 degrees.
constexpr double kLeastOpposition = 0.5;
// The rim gives way over this many times the distance that its end moves, and at least over the mouth's width.
constexpr double kBendLengths = 4;

Vec2 outward(Polyline const& run) { return -normalized(perpendicular(run.back() - run.front())); }

bool do_meet(Polyline const& a, Polyline const& b) {
  double const width = std::min(distance(a.front(), a.back()), distance(b.front(), b.back()));
  return width > 0 && distance(a.front(), b.back()) <= kReachShare * width &&
         distance(a.back(), b.front()) <= kReachShare * width &&
         dot(outward(a), outward(b)) <= -kLeastOpposition;
}

/// The point at a share of the line's length.
Vec2 point_at_share(Polyline const& line, double share) {
  double left = share * length(line);
  for (std::size_t i = 1; i < line.size(); ++i) {
    double const edge = distance(line[i - 1], line[i]);
    if (left <= edge && edge > 0) return lerp(line[i - 1], line[i], left / edge);
    left -= edge;
  }
  return line.back();
}

Polyline middle_line(Polyline const& a, Polyline const& b) {
  int const parts = static_cast<int>(std::max(a.size(), b.size())) - 1;
  Polyline line;
  for (int k = 0; k <= parts; ++k) {
    double const share = static_cast<double>(k) / parts;
    line.push_back(lerp(point_at_share(a, share), point_at_share(b, 1 - share), 0.5));
  }
  return line;
}

/// Moves the end of a line and, less and less, what lies before it.
void bend_end(Polyline& line, Vec2 by, double reach_px) {
  double way = 0;
  auto const original = line;
  for (std::size_t i = line.size(); i-- > 0;) {
    if (i + 1 < line.size()) way += distance(original[i], original[i + 1]);
    double const t = std::min(way / reach_px, 1.0);
    line[i] += by * ((1 - t) * (1 - t) * (1 + 2 * t));
  }
}

void replace_run(LayerRim& rim, int run, Polyline const& line) {
  int const count = static_cast<int>(std::ssize(rim.runs));
  auto& points = rim.runs[run].points;
  auto& before = rim.runs[(run + count - 1) % count].points;
  auto& after = rim.runs[(run + 1) % count].points;
  auto const bend = [&](Polyline& neighbour, Vec2 by) {
    // Half of a run at most, so that its other end stays where it is.
    double const reach = std::max(kBendLengths * norm(by), distance(line.front(), line.back()));
    bend_end(neighbour, by, std::min(reach, length(neighbour) / 2));
  };
  bend(before, line.front() - points.front());
  std::reverse(after.begin(), after.end());
  bend(after, line.back() - points.back());
  std::reverse(after.begin(), after.end());
  points = line;
  before.back() = line.front();
  after.front() = line.back();
}

}  // namespace

bool bring_together(LayerRim& a, int run_a, LayerRim& b, int run_b) {
  if (a.runs.size() < 2 || b.runs.size() < 2) return false;
  if (!do_meet(a.runs[run_a].points, b.runs[run_b].points)) return false;
  auto line = middle_line(a.runs[run_a].points, b.runs[run_b].points);
  auto changed_a = a;
  auto changed_b = b;
  replace_run(changed_a, run_a, line);
  std::reverse(line.begin(), line.end());
  replace_run(changed_b, run_b, line);
  if (!is_simple(outer_contour(changed_a)) || !is_simple(outer_contour(changed_b))) return false;
  a = std::move(changed_a);
  b = std::move(changed_b);
  return true;
}

}  // namespace inkflate
