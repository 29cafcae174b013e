// SPDX-License-Identifier: Apache-2.0
#include "render/mean_pen.h"

#include "image/to_byte.h"
#include "render/ink_line.h"

namespace inkflate {
namespace {

/// So that a line does not swell when an outline takes the place of strokes that were drawn lightly.
double mean_width(Stroke const& stroke) {
  if (stroke.samples.empty()) return stroke.width_px;
  double sum_px = 0;
  for (auto const& sample : stroke.samples) sum_px += pressed_width(stroke, sample);
  return sum_px / static_cast<double>(stroke.samples.size());
}

}  // namespace

std::optional<Pen> mean_pen(std::vector<Stroke const*> const& strokes) {
  double r = 0;
  double g = 0;
  double b = 0;
  double width_px = 0;
  double count = 0;
  for (auto const* const stroke : strokes) {
    if (stroke->kind == StrokeKind::HelpLine) continue;
    r += stroke->colour.r;
    g += stroke->colour.g;
    b += stroke->colour.b;
    width_px += mean_width(*stroke);
    count += 1;
  }
  if (count == 0) return std::nullopt;
  return Pen{width_px / count, {to_byte(r / count), to_byte(g / count), to_byte(b / count)}};
}

}  // namespace inkflate
