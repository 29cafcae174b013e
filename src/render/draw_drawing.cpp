// SPDX-License-Identifier: Apache-2.0
#include "render/draw_drawing.h"

#include <algorithm>

#include "render/draw_outline.h"
#include "render/ink_line.h"
#include "render/palette.h"

namespace inkflate {
namespace {

/// How wide a detail is at most, as a share of the outline.
constexpr double kDetailShare = 0.6;

void add_faint(DrawList& list, Sketch const& sketch, std::vector<int> const& strokes) {
  for (int const index : strokes) {
    auto stroke = sketch.strokes[static_cast<std::size_t>(index)];
    if (stroke.samples.empty()) continue;
    stroke.colour.a = palette::kFaintAlpha;
    list.push_back(ink_line(stroke));
  }
}

void add_strokes(DrawList& list, Sketch const& sketch, std::vector<int> const& strokes) {
  for (int const index : strokes) {
    auto const& stroke = sketch.strokes[static_cast<std::size_t>(index)];
    if (!stroke.samples.empty()) list.push_back(shown_line(stroke));
  }
}

void add_layer(DrawList& list, Layer const& layer, Sketch const& sketch, OutlinePen const& pen) {
  list.push_back(
      outline_area(layer.outlines, pen.tolerance_px, layer.fill.value_or(palette::kShape)));
  for (int const index : layer.details) {
    auto detail = sketch.strokes[static_cast<std::size_t>(index)];
    if (detail.kind == StrokeKind::HelpLine || detail.samples.empty()) continue;
    detail.width_px = std::min(detail.width_px, kDetailShare * pen.width_px);
    list.push_back(ink_line(detail));
  }
  append(list, outline_lines(layer.outlines, pen));
}

}  // namespace

DrawList draw_sketch(Sketch const& sketch) {
  DrawList list;
  for (auto const& stroke : sketch.strokes) {
    if (!stroke.samples.empty()) list.push_back(shown_line(stroke));
  }
  return list;
}

DrawList draw_drawing(Drawing const& drawing, DrawDrawingOptions const& options) {
  DrawList list;
  if (options.rough_strokes == RoughStrokes::Faint) {
    add_faint(list, drawing.sketch, drawing.stray);
    for (auto const& layer : drawing.layers) {
      if (is_shown(layer)) add_faint(list, drawing.sketch, layer.strokes);
    }
  }
  OutlinePen pen;
  pen.width_px = options.line_width_px;
  for (auto const& layer : drawing.layers) {
    if (is_shown(layer)) {
      add_layer(list, layer, drawing.sketch, pen);
    } else if (!layer.is_hidden) {
      add_strokes(list, drawing.sketch, layer.strokes);
    }
  }
  return list;
}

}  // namespace inkflate
