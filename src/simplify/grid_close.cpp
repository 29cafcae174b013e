// SPDX-License-Identifier: Apache-2.0
#include "simplify/grid_close.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "image/morphology.h"
#include "image/rasterise_line.h"
#include "image/trace_contour.h"
#include "simplify/grid_outline.h"

namespace inkflate {
namespace {

constexpr std::int32_t kMaxWeight = 100'000'000;  // five arcs fit into 32 bits
constexpr double kFarthestPx = 1e6;

std::optional<Error> find_fault(GridOptions const& options) {
  auto const& [ink, paper, terminal] = options.weights;
  for (auto const weight : {ink, paper, terminal}) {
    if (weight < 1 || weight > kMaxWeight) {
      return Error{ErrorCode::BadOption, "grid weights must be 1 to 100000000"};
    }
  }
  if (!(options.min_line_length_px >= 0)) {
    return Error{ErrorCode::BadOption, "the shortest line must not be negative"};
  }
  if (!std::all_of(options.outside.begin(), options.outside.end(), is_finite) ||
      !std::all_of(options.inside.begin(), options.inside.end(), is_finite)) {
    return Error{ErrorCode::BadOption, "marks must be finite"};
  }
  return std::nullopt;
}

std::optional<Error> find_fault(Sketch const& sketch) {
  if (!(sketch.width_px > 0 && sketch.height_px > 0)) {
    return Error{ErrorCode::BadInput, "the canvas has no size"};
  }
  if (sketch.width_px > kMaxGridSidePx || sketch.height_px > kMaxGridSidePx) {
    return Error{ErrorCode::TooLarge,
                 "the grid method takes canvases up to 4096 px; use --size to make it smaller"};
  }
  for (int i = 0; i < std::ssize(sketch.strokes); ++i) {
    for (auto const& sample : sketch.strokes[i].samples) {
      auto const p = sample.position;
      if (std::fabs(p.x) <= kFarthestPx && std::fabs(p.y) <= kFarthestPx) continue;
      return Error{ErrorCode::BadInput, "a sample is not finite or farther than 1e6 px", i};
    }
  }
  return std::nullopt;
}

struct Raster {
  Mask ink;         // all strokes
  Mask help_lines;  // only those, one pixel wider on all sides
};

Raster draw_strokes(Sketch const& sketch) {
  Mask const empty(static_cast<int>(std::ceil(sketch.width_px)),
                   static_cast<int>(std::ceil(sketch.height_px)));
  Raster raster = {empty, empty};
  Polyline points;
  for (auto const& stroke : sketch.strokes) {
    points.clear();
    for (auto const& sample : stroke.samples) points.push_back(sample.position);
    rasterise_polyline(points, raster.ink);
    if (stroke.kind == StrokeKind::HelpLine) rasterise_polyline(points, raster.help_lines);
  }
  raster.help_lines = dilate_3x3(raster.help_lines);
  return raster;
}

/// A point inside the loop, close to its uppermost point: the steps to it and from it are a pixel each, so nothing
/// comes between.
Vec2 point_inside(Contour const& loop) {
  auto const top =
      std::min_element(loop.begin(), loop.end(),
                       [](Vec2 a, Vec2 b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }) -
      loop.begin();
  auto const count = std::ssize(loop);
  return (loop[(top + count - 1) % count] + 2 * loop[top] + loop[(top + 1) % count]) / 4;
}

/// The loops of a piece, each outer one followed by its holes.
std::vector<std::vector<Contour>> group_loops(TracedPiece const& piece, Holes holes) {
  std::vector<std::vector<Contour>> groups;
  std::vector<Contour> inner;
  auto const sort_out = [&](Contour const& walk) {
    for (auto& loop : simple_loops(walk)) {
      if (signed_area(loop) > 0) {
        groups.push_back({std::move(loop)});
      } else {
        inner.push_back(std::move(loop));
      }
    }
  };
  sort_out(piece.outer);
  if (holes == Holes::Fill) return groups;
  for (auto const& hole : piece.holes) sort_out(hole);
  for (auto& hole : inner) {
    auto const p = point_inside(hole);
    int best = -1;
    for (int i = 0; i < std::ssize(groups); ++i) {
      if (!contains(groups[i][0], p)) continue;
      if (best < 0 || signed_area(groups[i][0]) < signed_area(groups[best][0])) best = i;
    }
    if (best >= 0) groups[best].push_back(std::move(hole));
  }
  return groups;
}

}  // namespace

Result<std::vector<Layer>> close_on_grid(Sketch const& sketch, GridOptions const& options,
                                         Progress const& progress) {
  Error const cancelled = {ErrorCode::Cancelled, "cancelled"};
  if (auto const fault = find_fault(options)) return *fault;
  if (auto const fault = find_fault(sketch)) return *fault;
  if (!progress.enter("draw strokes on pixels")) return cancelled;
  auto const raster = draw_strokes(sketch);
  if (!progress.enter("cut pixels")) return cancelled;
  auto const filled = cut_grid(raster.ink, options.weights, options.outside, options.inside);
  if (!progress.enter("trace pixels")) return cancelled;
  auto const shape = dilate_3x3(erode_3x3(filled));

  std::vector<Layer> layers;
  for (auto const& piece : trace_contours(shape)) {
    for (auto const& loops : group_loops(piece, options.holes)) {
      Layer layer;
      layer.name = "part " + std::to_string(layers.size() + 1);
      layer.outlines = outlines_of(loops, raster.help_lines, options.min_line_length_px);
      layers.push_back(std::move(layer));
    }
  }
  if (layers.empty()) {
    return Error{ErrorCode::NothingThere, "no stroke encloses or nearly encloses an area"};
  }
  return layers;
}

}  // namespace inkflate
