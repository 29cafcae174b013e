// SPDX-License-Identifier: Apache-2.0
#include "render/draw_layer.h"

#include <algorithm>

#include "render/ink_line.h"
#include "render/mean_pen.h"

namespace inkflate {
namespace {

/// A rough line is gone over several times, none exactly on the other: one in its place is wider than each. Not much:
/// half of it is on each sheet, and both sheets are steep there, so that a line looks several times as wide from the side.
constexpr double kCleanWidthFactor = 1.2;

Stroke const& stroke_at(Drawing const& drawing, int index) {
  return drawing.sketch.strokes[static_cast<std::size_t>(index)];
}

/// No line is wider on the surface than this times its width, unless it would be thinner in the drawing than a share.
constexpr double kWidestOnSurface = 2.8;
constexpr double kThinnestShare = 0.28;

}  // namespace

DrawList draw_clean_rims(Drawing const& drawing, Layer const& layer,
                         std::vector<RimLine> const& rims) {
  std::vector<Stroke const*> strokes;
  for (int const index : layer.strokes) strokes.push_back(&stroke_at(drawing, index));
  auto const pen = mean_pen(strokes);
  DrawList list;
  if (!pen || pen->width_px <= 0) return list;
  double const width_px = kCleanWidthFactor * pen->width_px;
  StrokedPolyline line;
  line.colour = pen->colour;
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
