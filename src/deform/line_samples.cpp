// SPDX-License-Identifier: Apache-2.0
#include "deform/line_samples.h"

#include <algorithm>
#include <cmath>

#include "mesh/rim_spacing.h"

namespace inkflate {
namespace {

// How far chords may leave the curve, as a share of the step.
constexpr double kChordShare = 0.01;
// Of one piece.
constexpr double kMostSteps = 4096;

void add(LineSamples& samples, Vec2 point, double parameter) {
  if (!samples.points.empty() && samples.points.back() == point) return;
  samples.points.push_back(point);
  samples.parameters.push_back(parameter);
}

int step_count(Cubic const& curve, double step_px) {
  double const steps = std::ceil(length(curve.control) / step_px);
  return std::max(flatten_count(curve, kChordShare * step_px),
                  static_cast<int>(std::clamp(steps, 1.0, kMostSteps)));
}

}  // namespace

LineSamples sample_outline(Outline const& outline, double step_px) {
  LineSamples samples;
  samples.is_closed = true;
  for (int i = 0; i < std::ssize(outline.pieces); ++i) {
    auto const& curve = outline.pieces[i].curve;
    int const count = step_count(curve, step_px);
    for (int k = 0; k < count; ++k) {
      double const t = static_cast<double>(k) / count;
      add(samples, point_at(curve, t), i + t);
    }
  }
  while (samples.points.size() > 1 && samples.points.back() == samples.points.front()) {
    samples.points.pop_back();
    samples.parameters.pop_back();
  }
  return samples;
}

LineSamples sample_line(Polyline const& line) {
  LineSamples samples;
  for (int i = 0; i < std::ssize(line); ++i) add(samples, line[i], i);
  return samples;
}

LineSamples thinned(LineSamples const& samples, std::span<double const> spacing) {
  auto points = samples.points;
  auto parameters = samples.parameters;
  std::vector<double> lengths(spacing.begin(), spacing.end());
  if (samples.is_closed) {
    points.push_back(points.front());
    parameters.push_back(std::floor(parameters.back()) + 1);
    lengths.push_back(lengths.front());
  }
  LineSamples result;
  result.is_closed = samples.is_closed;
  for (auto const& place : resample_places(points, lengths)) {
    int const next = std::min(place.edge + 1, static_cast<int>(std::ssize(points)) - 1);
    add(result, lerp(points[place.edge], points[next], place.share),
        parameters[place.edge] + (parameters[next] - parameters[place.edge]) * place.share);
  }
  if (result.is_closed && result.points.size() > 1) {
    result.points.pop_back();
    result.parameters.pop_back();
  }
  return result;
}

void put_onto(Outline const& outline, LineSamples& samples) {
  int const last = static_cast<int>(std::ssize(outline.pieces)) - 1;
  for (std::size_t k = 0; k < samples.points.size(); ++k) {
    double const parameter = samples.parameters[k];
    int const piece = std::clamp(static_cast<int>(parameter), 0, last);
    samples.points[k] = point_at(outline.pieces[piece].curve, parameter - piece);
  }
}

}  // namespace inkflate
