// SPDX-License-Identifier: Apache-2.0
#include "assemble/sample_rims.h"

#include <algorithm>
#include <cmath>

#include "geometry/crossings.h"
#include "mesh/rim_spacing.h"

namespace inkflate {
namespace {

// Edges along wide and along the thinnest parts, in units.
constexpr double kLongest = 9;
constexpr double kShortest = 1.5;
// Where points this far apart make a rim cross itself, half as far is tried, so many times.
constexpr int kRefinements = 4;

/// The wanted edge lengths of a layer: per run and per hole one length per point.
struct Spacing {
  std::vector<std::vector<double>> runs;
  std::vector<std::vector<double>> holes;
};

Spacing spacing_of(LayerRim const& rim, double unit_px, double density) {
  std::vector<Contour> contours = {outer_contour(rim)};
  contours.insert(contours.end(), rim.holes.begin(), rim.holes.end());
  double const scale = unit_px / std::sqrt(density);
  RimSpacingOptions options;
  options.longest_px = kLongest * scale;
  options.shortest_px = kShortest * scale;
  auto const lengths = rim_spacing(contours, options);
  Spacing spacing;
  std::size_t at = 0;
  auto const& outer = lengths.front();
  for (auto const& run : rim.runs) {
    std::vector<double> own;
    for (std::size_t i = 0; i < run.points.size(); ++i)
      own.push_back(outer[(at + i) % outer.size()]);
    spacing.runs.push_back(std::move(own));
    at += run.points.size() - 1;
  }
  spacing.holes.assign(lengths.begin() + 1, lengths.end());
  return spacing;
}

/// A closed run keeps its last point, which is its first one.
Polyline sample_run(Polyline const& line, std::vector<double> const& lengths) {
  bool const is_closed = line.front() == line.back();
  auto points = resample(line, lengths);
  // An open boundary needs a point between its ends, which both sheets share; a closed one at least a triangle.
  std::size_t const least = is_closed ? 4 : 3;
  if (points.size() >= least) return points;
  points.clear();
  for (std::size_t k = 0; k < least; ++k)
    points.push_back(line[k * (line.size() - 1) / (least - 1)]);
  return points;
}

Contour sample_hole(Contour const& hole, std::vector<double> lengths) {
  auto line = hole;
  line.push_back(hole.front());
  lengths.push_back(lengths.front());
  auto points = sample_run(line, lengths);
  points.pop_back();
  return points;
}

SampledRim sample(LayerRim const& rim, Spacing const& spacing) {
  SampledRim sampled;
  for (std::size_t r = 0; r < rim.runs.size(); ++r) {
    sampled.runs.push_back(sample_run(rim.runs[r].points, spacing.runs[r]));
  }
  for (std::size_t h = 0; h < rim.holes.size(); ++h) {
    sampled.holes.push_back(sample_hole(rim.holes[h], spacing.holes[h]));
  }
  return sampled;
}

void halve(std::vector<std::vector<double>>& lengths) {
  for (auto& each : lengths) {
    for (auto& length : each) length /= 2;
  }
}

/// A hole that touches itself or another line however finely it is sampled is smaller than what rounding can tell apart.
void fill_tangled_holes(SampledRim& rim) {
  for (;;) {
    auto const crossings = find_crossings(rim.contours(), 1);
    if (crossings.empty()) return;
    int const contour = std::max(crossings[0].contour_a, crossings[0].contour_b);
    if (contour == 0) return;
    rim.holes.erase(rim.holes.begin() + (contour - 1));
  }
}

SampledRim sample_without_crossings(LayerRim const& rim, double unit_px, double density) {
  auto spacing = spacing_of(rim, unit_px, density);
  for (int i = 0; i < kRefinements; ++i) {
    auto sampled = sample(rim, spacing);
    if (find_crossings(sampled.contours(), 1).empty()) return sampled;
    halve(spacing.runs);
    halve(spacing.holes);
  }
  SampledRim fine;
  for (auto const& run : rim.runs) fine.runs.push_back(run.points);
  fine.holes = rim.holes;
  fill_tangled_holes(fine);
  return fine;
}

}  // namespace

std::vector<Contour> SampledRim::contours() const {
  std::vector<Contour> all(1);
  for (auto const& run : runs) all[0].insert(all[0].end(), run.begin(), run.end() - 1);
  all.insert(all.end(), holes.begin(), holes.end());
  return all;
}

std::vector<SampledRim> sample_rims(std::span<LayerRim const> rims,
                                    std::span<PlannedJoint const> plan, double unit_px,
                                    double density) {
  std::vector<SampledRim> sampled;
  for (auto const& rim : rims) sampled.push_back(sample_without_crossings(rim, unit_px, density));
  for (auto const& joint : plan) {
    if (joint.host_run < 0) continue;
    auto& line = sampled[joint.host].runs[joint.host_run];
    line = sampled[joint.limb].runs[joint.run];
    std::reverse(line.begin(), line.end());
  }
  return sampled;
}

}  // namespace inkflate
