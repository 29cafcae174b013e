// SPDX-License-Identifier: Apache-2.0
#include "render/draw_outline.h"

#include <utility>

#include "render/line_pattern.h"

namespace inkflate {
namespace {

StrokedPolyline run_line(Run run, OutlinePen const& pen) {
  StrokedPolyline line;
  line.points = std::move(run.points);
  line.widths_px = {pen.width_px};
  line.colour = pen.ink;
  line.limits = pen.limits;
  if (run.kind == RunKind::Closing) {
    line.colour = palette::kClosing;
    line.dashes_px = dotted(pen.width_px);
  } else if (run.kind == RunKind::HelpLine) {
    line.colour = palette::kHelpLine;
    line.dashes_px = dashed(pen.width_px);
  }
  return line;
}

}  // namespace

FilledPath outline_area(std::vector<Outline> const& outlines, double tolerance_px, Colour colour) {
  FilledPath area;
  area.colour = colour;
  for (auto const& outline : outlines) area.contours.push_back(flatten(outline, tolerance_px));
  return area;
}

DrawList outline_lines(std::vector<Outline> const& outlines, OutlinePen const& pen) {
  DrawList list;
  for (auto const& outline : outlines) {
    for (auto& run : runs(outline, pen.tolerance_px)) list.push_back(run_line(std::move(run), pen));
  }
  return list;
}

}  // namespace inkflate
