// SPDX-License-Identifier: Apache-2.0
#include "render/ink_line.h"

#include <algorithm>

#include "render/line_pattern.h"
#include "render/palette.h"

namespace inkflate {
namespace {

/// The width of a line drawn without any pressure, as a share of the full width.
constexpr double kLightestPress = 0.4;

}  // namespace

double pressed_width(Stroke const& stroke, Sample const& sample) {
  double const press = std::clamp(sample.pressure, 0.0, 1.0);
  return stroke.width_px * (kLightestPress + (1 - kLightestPress) * press);
}

StrokedPolyline ink_line(Stroke const& stroke) {
  StrokedPolyline line;
  line.colour = stroke.colour;
  line.points.reserve(stroke.samples.size());
  line.widths_px.reserve(stroke.samples.size());
  for (auto const& sample : stroke.samples) {
    line.points.push_back(sample.position);
    line.widths_px.push_back(pressed_width(stroke, sample));
  }
  return line;
}

StrokedPolyline shown_line(Stroke const& stroke) {
  auto line = ink_line(stroke);
  if (stroke.kind == StrokeKind::HelpLine) {
    line.colour = palette::kHelpLine;
    line.dashes_px = dashed(std::max(stroke.width_px, 1.0));
  }
  return line;
}

}  // namespace inkflate
