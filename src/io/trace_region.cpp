// SPDX-License-Identifier: Apache-2.0
#include "io/trace_region.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/crossings.h"
#include "image/components.h"
#include "image/trace_contour.h"
#include "io/fit_loop.h"

namespace inkflate {
namespace {

constexpr long long kLeastAreaPx = 16;
// As polygons through the pixels' centres loops enclose less.
constexpr double kLeastLoopArea = 6;
constexpr long long kMostAreas = 1000;
// Shorter runs of one kind, in pixels of the boundary, are where lines cross or end.
constexpr int kLeastHelpRun = 4;
constexpr int kLeastInkRun = 3;
// Fine polygons show where a joint turns back, coarse ones where two sides come too close to be drawn.
constexpr std::array<double, 2> kTestTolerancesPx = {0.01, 0.2};

/// Sets small connected areas of what is not 0 to 0; tells how many are left.
long long remove_specks(Mask& mask, Neighbours neighbours) {
  auto const components = connected_components(mask, neighbours);
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    int const label = components.labels.values[i];
    if (label >= 0 && components.areas[static_cast<std::size_t>(label)] < kLeastAreaPx) {
      mask.values[i] = 0;
    }
  }
  return std::count_if(components.areas.begin(), components.areas.end(),
                       [](long long area) { return area >= kLeastAreaPx; });
}

Mask inverse(Mask mask) {
  for (auto& value : mask.values) value = value == 0 ? 255 : 0;
  return mask;
}

/// The value there, or else the strongest next to it.
std::uint8_t line_at(Mask const& lines, Vec2 p) {
  int const x = static_cast<int>(p.x);
  int const y = static_cast<int>(p.y);
  if (lines.at(x, y) != kNoLine) return lines.at(x, y);
  std::uint8_t found = kNoLine;
  for (int j = y - 1; j <= y + 1; ++j) {
    for (int i = x - 1; i <= x + 1; ++i) {
      if (!lines.contains(i, j) || lines.at(i, j) == kNoLine) continue;
      if (lines.at(i, j) == kInkLine) return kInkLine;
      found = lines.at(i, j);
    }
  }
  return found;
}

/// Gives runs of one kind that are too short the other one.
void flip_short_runs(std::vector<RunKind>& kinds, RunKind kind, RunKind other, int least) {
  int const count = static_cast<int>(std::ssize(kinds));
  auto const at = [&](int i) -> RunKind& { return kinds[static_cast<std::size_t>(i % count)]; };
  int start = 0;
  while (start < count && at(start) == kind) ++start;
  if (start == count) return;
  for (int i = start; i < start + count;) {
    int end = i;
    while (end < start + count && at(end) == kind) ++end;
    if (end - i < least) {
      for (int k = i; k < end; ++k) at(k) = other;
    }
    i = std::max(end, i + 1);
  }
}

std::vector<RunKind> kinds_of(Contour const& loop, Mask const& lines) {
  std::vector<RunKind> kinds;
  for (auto const point : loop) {
    kinds.push_back(line_at(lines, point) == kHelpLine ? RunKind::HelpLine : RunKind::Ink);
  }
  flip_short_runs(kinds, RunKind::HelpLine, RunKind::Ink, kLeastHelpRun);
  flip_short_runs(kinds, RunKind::Ink, RunKind::HelpLine, kLeastInkRun);
  return kinds;
}

/// An area as loops of pixels: the outer one, then holes.
using Loops = std::vector<Contour>;

std::vector<Loops> loops_of(TracedPiece const& piece) {
  std::vector<Loops> areas;
  for (auto& loop : simple_loops(piece.outer)) {
    if (signed_area(loop) >= kLeastLoopArea) areas.push_back({std::move(loop)});
  }
  for (auto const& walk : piece.holes) {
    for (auto& loop : simple_loops(walk)) {
      if (signed_area(loop) > -kLeastLoopArea) continue;
      auto const around = std::find_if(areas.begin(), areas.end(), [&](Loops const& area) {
        return contains(area[0], loop[0]);
      });
      if (around != areas.end()) around->push_back(std::move(loop));
    }
  }
  return areas;
}

/// Per outline: whether one of its polygons crosses itself or another one.
std::vector<bool> find_crossing(std::vector<Outline> const& outlines) {
  std::vector<bool> crosses(outlines.size(), false);
  std::vector<Contour> polygons(outlines.size());
  for (double const tolerance_px : kTestTolerancesPx) {
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      polygons[i] = flatten(outlines[i], tolerance_px);
    }
    for (auto const& crossing : find_crossings(polygons, 1000)) {
      crosses[static_cast<std::size_t>(crossing.contour_a)] = true;
      crosses[static_cast<std::size_t>(crossing.contour_b)] = true;
    }
  }
  return crosses;
}

/// Fits all loops of an area, with more and more care as long as there are crossings. Holes that touch what is around them
/// even so, because a wall is one pixel thin, are filled.
TracedRegion fit_area(Loops const& loops, Mask const& lines) {
  std::vector<std::vector<RunKind>> kinds;
  for (auto const& loop : loops) kinds.push_back(kinds_of(loop, lines));
  std::vector<LoopFit> fits(loops.size(), LoopFit::Smooth);
  TracedRegion outlines(loops.size());
  std::vector<bool> is_stale(loops.size(), true);
  while (std::find(is_stale.begin(), is_stale.end(), true) != is_stale.end()) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (is_stale[i]) outlines[i] = fit_loop(loops[i], kinds[i], fits[i]);
    }
    is_stale = find_crossing(outlines);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      is_stale[i] = is_stale[i] && fits[i] != LoopFit::Steps;
      if (is_stale[i]) fits[i] = static_cast<LoopFit>(static_cast<int>(fits[i]) + 1);
    }
  }
  auto const crosses = find_crossing(outlines);
  TracedRegion kept = {outlines[0]};
  for (std::size_t i = 1; i < outlines.size(); ++i) {
    if (!crosses[i]) kept.push_back(std::move(outlines[i]));
  }
  return kept;
}

}  // namespace

Result<std::vector<TracedRegion>> trace_region(Mask const& region, Mask const& lines) {
  auto background = inverse(region);
  auto count = remove_specks(background, Neighbours::Eight);
  auto clean = inverse(std::move(background));
  count += remove_specks(clean, Neighbours::Four);
  if (count > kMostAreas) {
    return Error{ErrorCode::TooLarge, "a region has more than 1000 separate areas and holes"};
  }
  std::vector<TracedRegion> regions;
  for (auto const& piece : trace_contours(clean)) {
    for (auto const& loops : loops_of(piece)) regions.push_back(fit_area(loops, lines));
  }
  return regions;
}

}  // namespace inkflate
