// SPDX-License-Identifier: Apache-2.0
#include "simplify/quick_shape.h"

#include <algorithm>
#include <iterator>

#include "simplify/centre_rim.h"
#include "simplify/closing_plan.h"
#include "simplify/cut_parts.h"
#include "simplify/rim_chains.h"
#include "simplify/smooth_contour.h"
#include "simplify/thin_samples.h"

namespace inkflate {
namespace {

// From so many samples on, those nearer to each other than their spacing are one; of fewer, only nearer ones. Rough drawings of any number
// of strokes keep about 10 000 then.
constexpr double kFullyThinnedSamples = 20'000;

// Ink is averaged over so many corners to each side: the pen's tremor.
constexpr int kAverage = 2;

StrokeSamples quick_samples(Sketch const& sketch, std::vector<int> const& strokes,
                            WorkSpace const& space) {
  auto samples = sample_strokes(sketch, strokes, space, kCutSpacingPx);
  auto const count = static_cast<double>(samples.points.size());
  if (count <= kQuickSamples) return samples;
  return thin_samples(sketch, samples,
                      samples.spacing_px * std::min(1.0, count / kFullyThinnedSamples));
}

/// The points of a chain with its end; of ink without the tremor.
Polyline chain_points(RimChain const& chain, Contour const& centred) {
  Polyline points;
  auto const count = std::ssize(centred);
  for (int k = 0; k <= chain.size; ++k) points.push_back(centred[(chain.first + k) % count]);
  if (chain.kind == RunKind::Closing) return points;
  if (!chain.is_ring) {
    smooth_open(points, kAverage);
    return points;
  }
  points.pop_back();
  smooth_closed(points, kAverage);
  points.push_back(points.front());
  return points;
}

void append_rim(Rim const& rim, Contour const& centred, WorkSpace const& space, QuickShape& shape) {
  auto const chains = cut_rim(rim, centred);
  Contour contour;
  std::vector<Polyline> closings;
  for (int c = 0; c < std::ssize(chains); ++c) {
    auto points = chain_points(chains[c], centred);
    for (auto& p : points) p = space.canvas_point(p);
    contour.insert(contour.end(), points.begin(), points.end() - 1);
    if (chains[c].kind != RunKind::Closing) continue;
    // A closing with a corner is two chains.
    if (c > 0 && chains[c - 1].kind == RunKind::Closing) {
      closings.back().insert(closings.back().end(), points.begin() + 1, points.end());
    } else {
      closings.push_back(std::move(points));
    }
  }
  // It may have that corner where the list starts.
  if (closings.size() > 1 && chains.front().kind == RunKind::Closing &&
      chains.back().kind == RunKind::Closing) {
    auto const& first = closings.front();
    closings.back().insert(closings.back().end(), first.begin() + 1, first.end());
    closings.front() = std::move(closings.back());
    closings.pop_back();
  }
  shape.contours.push_back(std::move(contour));
  std::move(closings.begin(), closings.end(), std::back_inserter(shape.closings));
}

/// The parts of one group.
void append_parts(CutParts const& cut, WorkSpace const& space, QuickShape& shape) {
  auto const& samples = cut.cells.samples;
  std::vector<Vec2> places;
  places.reserve(samples.points.size());
  for (auto const& point : samples.points) places.push_back(point.position);
  PointGrid const grid(places, CentreOptions{}.reach_px);
  for (auto const& part : cut.parts) {
    for (auto const& rim : part) append_rim(rim, centre_rim(rim, samples, grid), space, shape);
  }
  int const area = shape.areas.empty() ? 0 : shape.areas.back() + 1;
  shape.areas.resize(shape.contours.size(), area);
}

}  // namespace

Result<QuickShape> quick_shape(Sketch const& sketch, SimplifyOptions const& options,
                               Progress const& progress) {
  auto const plan = plan_closing(sketch, options);
  if (!plan) return plan.error();
  QuickShape shape;
  for (auto const& group : plan->groups) {
    if (group.is_left_out) continue;
    Error const cancelled = {ErrorCode::Cancelled, "stopped on request"};
    if (!progress.enter("sample")) return cancelled;
    auto const cut =
        cut_parts(sketch, quick_samples(sketch, plan->without_faint(group), plan->space),
                  plan->space, options, progress);
    if (!cut) return cut.error();
    if (!progress.enter("centre")) return cancelled;
    append_parts(*cut, plan->space, shape);
  }
  if (shape.contours.empty()) return nothing_enclosed();
  return shape;
}

}  // namespace inkflate
