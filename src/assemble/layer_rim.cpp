// SPDX-License-Identifier: Apache-2.0
#include "assemble/layer_rim.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "assemble/untangle_rim.h"

namespace inkflate {
namespace {

// A closing is an opening where it is at least this share of the part's width there: the end of a limb is as wide as the limb, a gap
// that the pen left in an outline is much smaller than the part.
constexpr double kLeastShareOfWidth = 0.5;

// And of the root of the part's area: even the mouth of a limb twenty times as long as it is wide is larger.
constexpr double kLeastShareOfSize = 0.15;

// A closing beside a help line that is shorter than this share of it only bridges the way to the ink.
constexpr double kBridgeShare = 0.5;

// A short run is sampled this finely at least, so that there is something to choose from.
constexpr int kLeastEdges = 6;

/// The diameter of the largest circle inside the outline that touches the run in its middle.
double width_at_middle(Polyline const& run, Contour const& outline) {
  auto const chord = run.back() - run.front();
  auto const inward = normalized(perpendicular(chord));
  auto const middle = run[run.size() / 2];
  double const own_radius = norm(chord) / 2;
  double least = std::numeric_limits<double>::infinity();
  for (auto const p : outline) {
    auto const to = p - middle;
    double const height = dot(to, inward);
    // Points of the run itself lie on the line through the circle's foot and would say nothing.
    if (height <= 0.05 * own_radius) continue;
    least = std::min(least, squared_norm(to) / height);
  }
  return least;
}

/// line: the run's points, finely sampled.
Opening opening_of(RunKind kind, Polyline const& line, Contour const& outline) {
  if (kind == RunKind::HelpLine) return Opening::Wanted;
  if (kind == RunKind::Ink) return Opening::None;
  double const gap = distance(line.front(), line.back());
  bool const is_mouth = gap >= kLeastShareOfSize * std::sqrt(std::abs(signed_area(outline))) &&
                        gap >= kLeastShareOfWidth * width_at_middle(line, outline);
  return is_mouth ? Opening::Possible : Opening::None;
}

/// Closings that only lead from the ink to a help line belong to it.
void widen_help_lines(std::vector<RimRun>& runs) {
  int const count = static_cast<int>(std::ssize(runs));
  auto const original = runs;
  for (int i = 0; i < count; ++i) {
    if (original[i].opening != Opening::Wanted) continue;
    for (int const j : {(i + 1) % count, (i + count - 1) % count}) {
      bool const is_closing = original[j].opening == Opening::Possible;
      if (is_closing && length(original[j].points) <= kBridgeShare * length(original[i].points)) {
        runs[j].opening = Opening::Wanted;
      }
    }
  }
}

void append_run(std::vector<RimRun>& runs, RimRun const& run) {
  if (runs.empty() || runs.back().opening != run.opening) {
    runs.push_back(run);
    return;
  }
  auto& points = runs.back().points;
  points.insert(points.end(), run.points.begin() + 1, run.points.end());
}

/// Makes one of neighbours of the same opening, also across the start of the list.
std::vector<RimRun> merge_runs(std::vector<RimRun> runs) {
  int const count = static_cast<int>(std::ssize(runs));
  int first = 0;
  for (int i = 0; i < count && first == 0; ++i) {
    if (runs[i].opening != runs[(i + count - 1) % count].opening) first = i;
  }
  std::vector<RimRun> merged;
  for (int i = 0; i < count; ++i) append_run(merged, runs[(first + i) % count]);
  return merged;
}

}  // namespace

Polyline densify(Polyline const& line, double step_px) {
  step_px = std::min(step_px, length(line) / kLeastEdges);
  Polyline fine = {line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    double const edge = distance(line[i - 1], line[i]);
    int const parts = static_cast<int>(std::ceil(std::min(edge / step_px, 1e5)));
    for (int k = 1; k < parts; ++k) {
      fine.push_back(lerp(line[i - 1], line[i], static_cast<double>(k) / parts));
    }
    if (edge > 0) fine.push_back(line[i]);
  }
  return fine;
}

LayerRim layer_rim(Layer const& layer, double step_px) {
  double const tolerance_px = step_px / 20;
  LayerRim rim;
  for (std::size_t i = 0; i < layer.outlines.size(); ++i) {
    auto const& outline = layer.outlines[i];
    auto const contour = flatten(outline, tolerance_px);
    if (i > 0) {
      auto closed = contour;
      closed.push_back(contour.front());
      auto fine = densify(closed, step_px);
      fine.pop_back();
      rim.holes.push_back(std::move(fine));
      continue;
    }
    auto const fine_contour = densify(contour, step_px);
    for (auto const& run : runs(outline, tolerance_px)) {
      auto line = densify(run.points, step_px);
      auto const opening = opening_of(run.kind, line, fine_contour);
      rim.runs.push_back({std::move(line), opening});
    }
    widen_help_lines(rim.runs);
    rim.runs = merge_runs(std::move(rim.runs));
    // Without any ink there is no rim that the sheets could share.
    if (rim.runs.size() == 1) rim.runs[0].opening = Opening::None;
  }
  return untangled(std::move(rim), step_px);
}

Contour outer_contour(LayerRim const& rim) {
  Contour contour;
  for (auto const& run : rim.runs)
    contour.insert(contour.end(), run.points.begin(), run.points.end() - 1);
  return contour;
}

}  // namespace inkflate
