// SPDX-License-Identifier: Apache-2.0
#include "render/mean_pen.h"

#include "image/to_byte.h"

namespace inkflate {

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
    width_px += stroke->width_px;
    count += 1;
  }
  if (count == 0) return std::nullopt;
  return Pen{width_px / count, {to_byte(r / count), to_byte(g / count), to_byte(b / count)}};
}

}  // namespace inkflate
