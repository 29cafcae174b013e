// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "simplify/close_strokes.h"
#include "simplify/grid_close.h"

namespace inkflate {
namespace {

double area(Layer const& layer) { return signed_area(flatten(layer.outlines.front(), 1)); }

/// The sketch with the other strokes empty, so that indices stay.
Sketch only(Sketch const& sketch, std::span<int const> chosen) {
  Sketch part = sketch;
  for (auto& stroke : part.strokes) stroke.samples.clear();
  for (int const s : chosen) part.strokes[s].samples = sketch.strokes[s].samples;
  return part;
}

}  // namespace

Result<std::vector<Layer>> close_by_grid(Sketch const& sketch, std::span<int const> chosen,
                                         SimplifyOptions const& options, Progress const& progress) {
  GridOptions grid;
  grid.holes = options.holes;
  grid.outside = options.outside;
  grid.inside = options.inside;
  auto layers = close_on_grid(only(sketch, chosen), grid, progress);
  if (!layers && layers.error().code == ErrorCode::NothingThere) return std::vector<Layer>{};
  if (!layers) return layers.error();
  std::stable_sort(layers->begin(), layers->end(),
                   [](Layer const& a, Layer const& b) { return area(a) > area(b); });
  if (options.parts == Parts::One) layers->resize(1);
  return layers;
}

}  // namespace inkflate
