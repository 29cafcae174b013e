// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/polyline.h"
#include "model/drawing.h"

namespace inkflate {

/// Points of a line and where on it they lie: of an outline its parameter (index of the piece + t), of a polyline the index of the
/// point + fraction.
struct LineSamples {
  Polyline points;
  std::vector<double> parameters;  // ascending, one per point
  bool is_closed = false;          // the last point is followed by the first, which is not repeated
};

/// The outline by points no farther apart than this along it and no chord farther from it than a hundredth of that. Points that
/// coincide with the one before are left out.
/// in      step_px: > 0
LineSamples sample_outline(Outline const& outline, double step_px);

/// The polyline's own points, but for those that coincide with the one before.
LineSamples sample_line(Polyline const& line);

/// Fewer points of the same line, about as far apart as wanted there; corners stay (mesh/rim_spacing.h).
/// in      samples: at least two points, three if closed; spacing: one length > 0 per point
LineSamples thinned(LineSamples const& samples, std::span<double const> spacing);

/// The same points, moved onto the curves of the outline.
void put_onto(Outline const& outline, LineSamples& samples);

}  // namespace inkflate
