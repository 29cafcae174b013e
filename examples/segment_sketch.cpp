// SPDX-License-Identifier: Apache-2.0
// segment_sketch IN.svg OUT.png: what the strokes of a drawing enclose or nearly enclose, white on black, by the thesis' minimum
// cut on pixels (section 3.2, eq. 3.4).
#include "image/morphology.h"
#include "image/rasterise_line.h"
#include "io/write_png.h"
#include "pipeline/place_sketch.h"
#include "simplify/grid_cut.h"
#include "sketch_files.h"

namespace {

using namespace inkflate;

constexpr double kCanvasPx = 512;

/// The strokes as pixels, help lines too: they close outlines.
Mask ink_of(Sketch const& sketch) {
  Mask ink(static_cast<int>(sketch.width_px), static_cast<int>(sketch.height_px));
  for (auto const& stroke : sketch.strokes) rasterise_polyline(line_of(stroke), ink);
  return ink;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return fail("usage: segment_sketch IN.svg OUT.png");
  auto const drawn = read_sketch(arguments[1]);
  if (!drawn) return fail(drawn.error().message);
  auto const sketch = place_sketch(*drawn, {kCanvasPx, PlaceMode::FitStrokes});
  if (!sketch) return fail(sketch.error().message);
  // Lines that stick out go.
  auto const mask = dilate_3x3(erode_3x3(cut_grid(ink_of(*sketch), GridWeights{})));
  if (!write_bytes(arguments[2], write_png(mask))) return fail("The picture cannot be written.");
  return 0;
}
