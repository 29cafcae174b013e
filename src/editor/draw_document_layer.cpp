// SPDX-License-Identifier: Apache-2.0
#include "editor/draw_document_layer.h"

#include <algorithm>
#include <utility>

#include "editor/scene_strokes.h"
#include "render/draw_outline.h"
#include "render/ink_line.h"
#include "render/mean_pen.h"

namespace inkflate {
namespace {

/// Close up, an outline is no wider than this on the screen: one looks there to see where it runs.
constexpr double kWidestOutlinePx = 16;

/// Of the stale area, beside the outline.
constexpr double kStaleShare = 0.5;

Stroke const& stroke_at(DocumentLayer const& layer, int index) {
  return layer.strokes[index]->stroke;
}

/// The pen of the outlines: as the strokes that they were made of.
OutlinePen outline_pen(DocumentLayer const& layer, double tolerance_px) {
  OutlinePen pen;
  pen.tolerance_px = tolerance_px;
  pen.limits = {kThinnestLinePx, kWidestOutlinePx};
  std::vector<Stroke const*> strokes;
  for (int const index : layer.layer.strokes) strokes.push_back(&stroke_at(layer, index));
  if (auto const mean = mean_pen(strokes); mean && mean->width_px > 0) {
    pen.width_px = mean->width_px;
    pen.ink = mean->colour;
  }
  return pen;
}

/// The fill over the skin: no area lets shine through what it hides.
Colour opaque(std::optional<Colour> const& fill) {
  if (!fill) return palette::kSkin;
  auto const over = [&](std::uint8_t upper, std::uint8_t lower) {
    int const sum = upper * fill->a + lower * (255 - fill->a);
    return static_cast<std::uint8_t>((sum + 127) / 255);
  };
  return {over(fill->r, palette::kSkin.r), over(fill->g, palette::kSkin.g),
          over(fill->b, palette::kSkin.b)};
}

struct HighlightPen {
  double width_px = 0;
  double halo_px = 0;
};

HighlightPen pen_of(Highlight highlight) {
  return highlight == Highlight::Selected ? HighlightPen{2.25, 5.5} : HighlightPen{1.25, 3.25};
}

/// The lines that a highlight follows.
std::vector<Polyline> rims(DocumentLayer const& layer, double tolerance_px) {
  std::vector<Polyline> lines;
  for (auto const& outline : layer.layer.outlines) {
    auto line = flatten(outline, tolerance_px);
    if (line.empty()) continue;
    line.push_back(line.front());
    lines.push_back(std::move(line));
  }
  if (!lines.empty()) return lines;
  layer.strokes.for_each([&](Shared<KeptStroke> const& kept) {
    Polyline line;
    for (auto const& sample : kept->stroke.samples) line.push_back(sample.position);
    if (!line.empty()) lines.push_back(std::move(line));
  });
  return lines;
}

}  // namespace

DrawList draw_closed_layer(DocumentLayer const& layer, double tolerance_px) {
  auto const pen = outline_pen(layer, tolerance_px);
  DrawList list;
  if (!layer.layer.outlines.empty()) {
    list.push_back(outline_area(layer.layer.outlines, tolerance_px, opaque(layer.layer.fill)));
  }
  for (int const index : layer.layer.details) {
    auto const& detail = stroke_at(layer, index);
    if (detail.kind == StrokeKind::HelpLine || detail.samples.empty()) continue;
    auto line = ink_line(detail);
    line.limits.least_px = kThinnestLinePx;
    list.push_back(std::move(line));
  }
  append(list, outline_lines(layer.layer.outlines, pen));
  return list;
}

DrawList draw_hidden_ink(DrawList const& list) {
  DrawList hidden;
  for (auto const& item : list) {
    auto const* const line = std::get_if<StrokedPolyline>(&item);
    if (!line) continue;
    auto pale = *line;
    pale.colour = faded(pale.colour, palette::kFaintAlpha / 255.0);
    hidden.push_back(std::move(pale));
  }
  return hidden;
}

DrawList draw_stale_outlines(DocumentLayer const& layer, double tolerance_px) {
  if (layer.layer.outlines.empty()) return {};
  DrawList list = {
      outline_area(layer.layer.outlines, tolerance_px, faded(palette::kShape, kStaleShare))};
  append(list,
         draw_hidden_ink(outline_lines(layer.layer.outlines, outline_pen(layer, tolerance_px))));
  return list;
}

DrawList draw_highlight(DocumentLayer const& layer, Highlight highlight, double tolerance_px) {
  auto const pen = pen_of(highlight);
  DrawList list;
  auto const lines = rims(layer, tolerance_px);
  auto const add = [&](double width_px, Colour colour) {
    for (auto const& points : lines) {
      list.push_back(StrokedPolyline{points, {width_px}, {}, colour, {width_px, width_px}});
    }
  };
  // All halos first: none lies over a line.
  add(pen.halo_px, palette::kHalo);
  add(pen.width_px, palette::kSelection);
  return list;
}

}  // namespace inkflate
