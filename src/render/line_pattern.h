// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace inkflate {

/// How lines are told apart that are no ink, whatever their colour: for StrokedPolyline::dashes_px. width_px > 0.

/// Help lines.
inline std::vector<double> dashed(double width_px) { return {3 * width_px, 3 * width_px}; }
/// Bridges over gaps.
inline std::vector<double> dotted(double width_px) { return {0, 2 * width_px}; }

}  // namespace inkflate
