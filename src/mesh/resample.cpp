// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "mesh/rim_spacing.h"

namespace inkflate {
namespace {

// Of one piece of a line; more would be a mistake in the spacing.
constexpr double kMostEdges = 1e6;
// How far to both sides a bend is looked for, as a share of the spacing, and how far the line must leave the chord between there to be a
// corner, as a share of that. A turn by 30 degrees is one; a disc sampled at a tenth of its width leaves chords by 0.08.
constexpr double kCornerReach = 0.75;
constexpr double kCornerDepth = 0.25;

/// A line with the way to each of its points, and how many edges are wanted up to there.
struct Measured {
  std::span<Vec2 const> line;
  std::span<double const> spacing;
  std::vector<double> along_px = {0};
  std::vector<double> amounts = {0};

  int last() const { return static_cast<int>(std::ssize(line)) - 1; }
  Vec2 at(double way_px) const {
    auto const next = std::upper_bound(along_px.begin() + 1, along_px.end() - 1, way_px);
    auto const i = next - along_px.begin();
    double const length_px = along_px[i] - along_px[i - 1];
    return length_px > 0 ? lerp(line[i - 1], line[i], (way_px - along_px[i - 1]) / length_px)
                         : line[i];
  }
};

Measured measure(std::span<Vec2 const> line, std::span<double const> spacing) {
  Measured measured = {line, spacing};
  for (std::size_t i = 1; i < line.size(); ++i) {
    double const length_px = distance(line[i - 1], line[i]);
    double const density = (1 / spacing[i - 1] + 1 / spacing[i]) / 2;
    measured.along_px.push_back(measured.along_px.back() + length_px);
    measured.amounts.push_back(measured.amounts.back() + length_px * density);
  }
  return measured;
}

/// How far point i lies from the chord over it, as a share of the chord's reach; 0 next to an end of the line.
double bend(Measured const& measured, int i) {
  double const reach = kCornerReach * measured.spacing[i];
  double const way = measured.along_px[i];
  if (way < reach || way + reach > measured.along_px.back()) return 0;
  return std::sqrt(squared_distance_to_segment(measured.line[i], measured.at(way - reach),
                                               measured.at(way + reach))) /
         reach;
}

/// The points at which the line is cut into pieces: its ends and its corners. Of corners closer than the reach the sharpest counts.
std::vector<int> piece_ends(Measured const& measured) {
  std::vector<int> ends = {0};
  double last_bend = 0;
  for (int i = 1; i < measured.last(); ++i) {
    double const here = bend(measured, i);
    if (here < kCornerDepth) continue;
    bool const is_near = last_bend > 0 && measured.along_px[i] - measured.along_px[ends.back()] <
                                              kCornerReach * measured.spacing[i];
    if (is_near && here <= last_bend) continue;
    if (is_near) ends.pop_back();
    ends.push_back(i);
    last_bend = here;
  }
  ends.push_back(measured.last());
  return ends;
}

/// How many edges each piece gets.
std::vector<int> edge_counts(Measured const& measured, std::vector<int> const& ends) {
  std::vector<int> counts;
  int sum = 0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    double const amount = measured.amounts[ends[k]] - measured.amounts[ends[k - 1]];
    counts.push_back(
        static_cast<int>(std::max(1.0, std::min(kMostEdges, std::floor(amount + 0.5)))));
    sum += counts.back();
  }
  int const least = measured.line.front() == measured.line.back() ? 3 : 1;
  if (sum < least) counts[0] += least - sum;
  return counts;
}

/// How far along an edge of the line, 0 .. 1, the given amount is reached when the density goes evenly from start to end.
double share_reached(double amount, double length_px, double start, double end) {
  double const root = start * start + 2 * (end - start) * amount / length_px;
  double const share = 2 * amount / (start + std::sqrt(std::max(0.0, root))) / length_px;
  return share < 1 ? share : 1;
}

/// The places inside of a piece, then its end.
void append_piece(Measured const& measured, int from, int to, int count,
                  std::vector<LinePlace>& result) {
  auto const& amounts = measured.amounts;
  double const total = amounts[to] - amounts[from];
  int i = from + 1;
  for (int k = 1; k < count; ++k) {
    double const wanted = amounts[from] + total * k / count;
    while (i < to && amounts[i] < wanted) ++i;
    double const length_px = measured.along_px[i] - measured.along_px[i - 1];
    double const share = share_reached(wanted - amounts[i - 1], length_px,
                                       1 / measured.spacing[i - 1], 1 / measured.spacing[i]);
    result.push_back({i - 1, share});
  }
  result.push_back({to, 0});
}

}  // namespace

std::vector<LinePlace> resample_places(std::span<Vec2 const> line,
                                       std::span<double const> spacing) {
  CHECK(line.size() >= 2 && line.size() == spacing.size(), "a line has a spacing at each point");
  auto const measured = measure(line, spacing);
  auto const ends = piece_ends(measured);
  auto const counts = edge_counts(measured, ends);
  std::vector<LinePlace> result = {{0, 0}};
  for (std::size_t k = 1; k < ends.size(); ++k)
    append_piece(measured, ends[k - 1], ends[k], counts[k - 1], result);
  return result;
}

Polyline resample(std::span<Vec2 const> line, std::span<double const> spacing) {
  Polyline result;
  for (auto const& place : resample_places(line, spacing)) {
    auto const start = line[place.edge];
    result.push_back(place.share > 0 ? lerp(start, line[place.edge + 1], place.share) : start);
  }
  return result;
}

}  // namespace inkflate
