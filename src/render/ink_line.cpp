// SPDX-License-Identifier: Apache-2.0
#include "render/ink_line.h"

#include <algorithm>

namespace inkflate {
namespace {

/// The width of a line drawn without any pressure, as a share of the full width.
constexpr double kLightestPress = 0.4;

}  // namespace

StrokedPolyline ink_line(Stroke const& stroke) {
  StrokedPolyline line;
  line.colour = stroke.colour;
  for (auto const& sample : stroke.samples) {
    double const press = std::clamp(sample.pressure, 0.0, 1.0);
    line.points.push_back(sample.position);
    line.widths_px.push_back(stroke.width_px * (kLightestPress + (1 - kLightestPress) * press));
  }
  return line;
}

}  // namespace inkflate
