// SPDX-License-Identifier: Apache-2.0
#include "render/draw_layer.h"

#include <algorithm>

#include "image/to_byte.h"
#include "render/ink_line.h"

namespace inkflate {
namespace {

/// A rough line is gone over several times, none exactly on the other: one in its place is wider than each. Not much:
/// half of it is on each sheet, and both sheets are steep there, so that a line looks several times as wide from the side.
constexpr double kCleanWidthFactor = 1.2;

Stroke const& stroke_at(Drawing const& drawing, int index) {
  return drawing.sketch.strokes[static_cast<std::size_t>(index)];
}

/// No line is wider on the surface than this times its width, unless it would be thinner in the drawing than a share.
constexpr double kWidestOnSurface = 4;
constexpr double kThinnestShare = 0.35;

/// Colour and width of the layer's outline strokes on average.
StrokedPolyline mean_pen(Drawing const& drawing, Layer const& layer) {
  double r = 0;
  double g = 0;
  double b = 0;
  double width_px = 0;
  double count = 0;
  for (int const index : layer.strokes) {
    auto const& stroke = stroke_at(drawing, index);
    if (stroke.kind == StrokeKind::HelpLine) continue;
    r += stroke.colour.r;
    g += stroke.colour.g;
    b += stroke.colour.b;
    width_px += stroke.width_px;
    count += 1;
  }
  if (count == 0) return {{}, {0}, {}, {}};
  return {{},
          {kCleanWidthFactor * width_px / count},
          {},
          {to_byte(r / count), to_byte(g / count), to_byte(b / count)}};
}

}  // namespace

DrawList draw_clean_rims(Drawing const& drawing, Layer const& layer,
                         std::vector<RimLine> const& rims) {
  auto line = mean_pen(drawing, layer);
  DrawList list;
  if (line.widths_px[0] <= 0) return list;
  double const width_px = line.widths_px[0];
  for (auto const& rim : rims) {
    line.points = rim.points;
    line.widths_px.clear();
    for (double const steepness : rim.steepness) {
      line.widths_px.push_back(width_px *
                               std::clamp(kWidestOnSurface / steepness, kThinnestShare, 1.0));
    }
    list.push_back(line);
  }
  return list;
}

DrawList draw_ink(Drawing const& drawing, std::vector<int> const& strokes) {
  DrawList list;
  for (int const index : strokes) {
    auto const& stroke = stroke_at(drawing, index);
    if (stroke.kind == StrokeKind::HelpLine || stroke.samples.empty()) continue;
    list.push_back(ink_line(stroke));
  }
  return list;
}

}  // namespace inkflate
