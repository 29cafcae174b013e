// SPDX-License-Identifier: Apache-2.0
#include "ink/trace_scan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "image/filter.h"
#include "image/thin.h"
#include "ink/find_sheet.h"
#include "ink/flatten_paper.h"
#include "ink/ink_colour.h"
#include "ink/ink_mask.h"
#include "ink/join_lines.h"
#include "ink/refine_line.h"
#include "ink/split_kinds.h"

namespace inkflate {
namespace {

/// A drawing of which more than this share is blue is a drawing in blue.
constexpr double kMostHelpLines = 0.6;

std::optional<Error> check_options(ScanOptions const& options) {
  if (options.work_side_px < 64 || options.work_side_px > 8192) {
    return Error{ErrorCode::BadOption, "the work size of a scan must be 64 to 8192 px"};
  }
  if (!(options.ink_threshold >= 0.1 && options.ink_threshold <= 2)) {
    return Error{ErrorCode::BadOption, "the ink threshold of a scan must be 0.1 to 2"};
  }
  return std::nullopt;
}

Error empty_page() {
  return {ErrorCode::NothingThere,
          "no lines were found on the page: use a darker pen or a sharper picture, or crop it to "
          "the drawing"};
}

/// The picture over white, not larger than the work allows.
Picture work_picture(Picture const& picture, int work_side_px) {
  int const longer = std::max(picture.width, picture.height);
  double const scale = std::min(1.0, static_cast<double>(work_side_px) / longer);
  auto const side = [&](int side_px) {
    return std::max(1, static_cast<int>(std::floor(side_px * scale + 0.5)));
  };
  auto work = scale < 1 ? shrink(picture, side(picture.width), side(picture.height)) : picture;
  return over_white(std::move(work));
}

/// The lines of the ink, each of one kind.
std::vector<JoinedLine> find_lines(InkMask const& ink, Picture const& colour,
                                   HelpLineInk help_line_ink) {
  auto graph = line_graph(thin(ink.lines), ink.radius_px);
  prune_spurs(graph);
  merge_crossings(graph);
  if (help_line_ink == HelpLineInk::Blue) split_kinds(graph, colour);
  return join_lines(graph);
}

bool is_mostly_help_lines(std::vector<JoinedLine> const& lines) {
  double all_px = 0;
  double help_px = 0;
  for (auto const& line : lines) {
    double const line_px = length(line.points);
    all_px += line_px;
    if (line.kind == kHelpLineKind) help_px += line_px;
  }
  return help_px > kMostHelpLines * all_px;
}

/// scale_x, scale_y: picture px per px of the work.
Stroke stroke_of(RefinedLine const& line, StrokeKind kind, Colour colour, double scale_x,
                 double scale_y) {
  Stroke stroke;
  stroke.kind = kind;
  stroke.colour = colour;
  stroke.width_px = line.width_px * std::sqrt(scale_x * scale_y);
  for (auto const p : line.points) {
    stroke.samples.push_back(Sample{{p.x * scale_x, p.y * scale_y}, 1});
  }
  return stroke;
}

}  // namespace

Result<Sketch> trace_scan(Picture const& picture, ScanOptions const& options,
                          Progress const& progress) {
  Error const cancelled = {ErrorCode::Cancelled, "cancelled"};
  if (auto error = check_options(options)) return *error;
  if (picture.values.empty()) return empty_page();
  if (!progress.enter("paper")) return cancelled;
  auto work = work_picture(picture, options.work_side_px);
  auto const sheet = find_sheet(work);
  if (is_drawn_on_dark(work, sheet)) work = with_lightness_turned(std::move(work));
  auto const flat = flatten_paper(work, sheet);
  if (!progress.enter("ink")) return cancelled;
  auto const ink = find_ink(flat.strength, sheet, options.ink_threshold);
  if (!progress.enter("lines")) return cancelled;
  auto const lines = find_lines(ink, flat.colour, options.help_line_ink);
  if (lines.empty()) return empty_page();

  Sketch sketch;
  sketch.width_px = picture.width;
  sketch.height_px = picture.height;
  double const scale_x = static_cast<double>(picture.width) / work.width;
  double const scale_y = static_cast<double>(picture.height) / work.height;
  bool const has_help_lines = !is_mostly_help_lines(lines);
  for (auto const& line : lines) {
    bool const is_help_line = has_help_lines && line.kind == kHelpLineKind;
    sketch.strokes.push_back(stroke_of(refine_line(line, flat.strength, ink.radius_px),
                                       is_help_line ? StrokeKind::HelpLine : StrokeKind::Ink,
                                       median_colour(flat.colour, line.points), scale_x, scale_y));
  }
  return sketch;
}

}  // namespace inkflate
