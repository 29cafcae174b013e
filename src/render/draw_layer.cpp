// SPDX-License-Identifier: Apache-2.0
#include "render/draw_layer.h"

#include <algorithm>

#include "image/to_byte.h"
#include "render/ink_line.h"

namespace inkflate {
namespace {

/// A quarter of a texel at most.
constexpr double kFlattenTolerancePx = 0.1;
/// A rough line is gone over several times, none exactly on the other: one stroke in its place is wider than each.
constexpr double kCleanWidthFactor = 1.6;

Stroke const& stroke_at(Drawing const& drawing, int index) {
  return drawing.sketch.strokes[static_cast<std::size_t>(index)];
}

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

void add_clean_outline(DrawList& list, Drawing const& drawing, Layer const& layer) {
  auto line = mean_pen(drawing, layer);
  if (line.widths_px[0] <= 0) return;
  for (auto const& outline : layer.outlines) {
    for (auto& run : runs(outline, kFlattenTolerancePx)) {
      if (run.kind != RunKind::Ink) continue;
      line.points = std::move(run.points);
      list.push_back(line);
    }
  }
}

void add_strokes(DrawList& list, Drawing const& drawing, std::vector<int> const& indices) {
  for (int const index : indices) {
    auto const& stroke = stroke_at(drawing, index);
    if (stroke.kind == StrokeKind::HelpLine || stroke.samples.empty()) continue;
    list.push_back(ink_line(stroke));
  }
}

}  // namespace

DrawList draw_layer_ink(Drawing const& drawing, Layer const& layer, OutlineLook outline,
                        BackDetails details) {
  DrawList list;
  std::vector<int> indices;
  if (outline == OutlineLook::Clean) {
    add_clean_outline(list, drawing, layer);
  } else {
    indices = layer.strokes;
  }
  if (details == BackDetails::Shown) {
    indices.insert(indices.end(), layer.details.begin(), layer.details.end());
  }
  std::sort(indices.begin(), indices.end());  // as they were drawn
  add_strokes(list, drawing, indices);
  return list;
}

}  // namespace inkflate
