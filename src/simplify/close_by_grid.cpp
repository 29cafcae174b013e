// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "simplify/close_strokes.h"
#include "simplify/grid_close.h"
#include "simplify/sort_strokes.h"

namespace inkflate {
namespace {

// Distance of the samples by which strokes are given to layers, frame px.
constexpr double kSpacing_px = 3;

double area(Layer const& layer) { return signed_area(flatten(layer.outlines.front(), 1)); }

/// The sketch with the other strokes empty, so that indices stay.
Sketch only(Sketch const& sketch, std::span<int const> chosen) {
  Sketch part = sketch;
  for (auto& stroke : part.strokes) stroke.samples.clear();
  for (int const s : chosen) part.strokes[s].samples = sketch.strokes[s].samples;
  return part;
}

}  // namespace

Result<ClosedStrokes> close_by_grid(Sketch const& sketch, std::span<int const> chosen,
                                    Frame const& frame, SimplifyOptions const& options,
                                    Progress const& progress) {
  GridOptions grid;
  grid.holes = options.holes;
  grid.outside = options.outside;
  grid.inside = options.inside;
  auto layers = close_on_grid(only(sketch, chosen), grid, progress);
  ClosedStrokes result;
  if (layers) {
    result.layers = *std::move(layers);
  } else if (layers.error().code != ErrorCode::NothingThere) {
    return layers.error();
  }
  std::stable_sort(result.layers.begin(), result.layers.end(),
                   [](Layer const& a, Layer const& b) { return area(a) > area(b); });
  if (options.parts != Parts::All && result.layers.size() > 1) result.layers.resize(1);
  if (!progress.enter("sort")) return Error{ErrorCode::Cancelled, "stopped on request"};
  result.stray =
      sort_strokes(sample_strokes(sketch, chosen, frame, kSpacing_px), frame, result.layers);
  return result;
}

}  // namespace inkflate
