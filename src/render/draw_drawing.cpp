// SPDX-License-Identifier: Apache-2.0
#include "render/draw_drawing.h"

#include <algorithm>

#include "render/ink_line.h"
#include "render/palette.h"

namespace inkflate {
namespace {

/// Finer than an antialiased picture can show.
constexpr double kFlattenTolerancePx = 0.05;
constexpr std::uint8_t kFaintAlpha = 64;  // 25 %, as hidden ink

std::vector<double> dashed(double width_px) { return {3 * width_px, 3 * width_px}; }
std::vector<double> dotted(double width_px) { return {0, 2 * width_px}; }

void add_stroke(DrawList& list, Stroke const& stroke) {
  if (stroke.samples.empty()) return;
  auto line = ink_line(stroke);
  if (stroke.kind == StrokeKind::HelpLine) {
    line.colour = palette::kHelpLine;
    line.dashes_px = dashed(std::max(stroke.width_px, 1.0));
  }
  list.push_back(std::move(line));
}

void add_faint(DrawList& list, Sketch const& sketch, std::vector<int> const& strokes) {
  for (int const index : strokes) {
    auto stroke = sketch.strokes[static_cast<std::size_t>(index)];
    if (stroke.samples.empty()) continue;
    stroke.colour.a = kFaintAlpha;
    list.push_back(ink_line(stroke));
  }
}

void add_run(DrawList& list, Run const& run, double width_px) {
  StrokedPolyline line;
  line.points = run.points;
  line.widths_px = {width_px};
  line.colour = palette::kInk;
  if (run.kind == RunKind::Closing) {
    line.colour = palette::kClosing;
    line.dashes_px = dotted(width_px);
  } else if (run.kind == RunKind::HelpLine) {
    line.colour = palette::kHelpLine;
    line.dashes_px = dashed(width_px);
  }
  list.push_back(std::move(line));
}

void add_strokes(DrawList& list, Sketch const& sketch, std::vector<int> const& strokes) {
  for (int const index : strokes) add_stroke(list, sketch.strokes[static_cast<std::size_t>(index)]);
}

void add_layer(DrawList& list, Layer const& layer, Sketch const& sketch, double width_px) {
  FilledPath shape;
  shape.colour = layer.fill.value_or(palette::kShape);
  for (auto const& outline : layer.outlines) {
    shape.contours.push_back(flatten(outline, kFlattenTolerancePx));
  }
  list.push_back(std::move(shape));
  for (int const index : layer.details) {
    auto detail = sketch.strokes[static_cast<std::size_t>(index)];
    if (detail.kind == StrokeKind::HelpLine) continue;
    detail.width_px = std::min(detail.width_px, 0.6 * width_px);
    add_stroke(list, detail);
  }
  for (auto const& outline : layer.outlines) {
    for (auto const& run : runs(outline, kFlattenTolerancePx)) add_run(list, run, width_px);
  }
}

}  // namespace

DrawList draw_sketch(Sketch const& sketch) {
  DrawList list;
  for (auto const& stroke : sketch.strokes) add_stroke(list, stroke);
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
  for (auto const& layer : drawing.layers) {
    if (is_shown(layer)) {
      add_layer(list, layer, drawing.sketch, options.line_width_px);
    } else if (!layer.is_hidden) {
      add_strokes(list, drawing.sketch, layer.strokes);
    }
  }
  return list;
}

}  // namespace inkflate
