// SPDX-License-Identifier: Apache-2.0
// contact_sheet OUT.png COLUMNS FILE.svg...: rough sketches, each with what simplify makes of it at its right.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "io/read_svg.h"
#include "io/write_png.h"
#include "render/draw_drawing.h"
#include "render/palette.h"
#include "render/rasterise.h"
#include "simplify/simplify.h"

namespace {

using namespace inkflate;

// Four pairs of sketches of 1000 x 800 px side by side are 2000 px wide.
constexpr double kScale = 0.23;
constexpr double kCellWidthPx = 234;
constexpr double kCellHeightPx = 188;
constexpr double kBetweenPairsPx = 25;
// Thinner ones would fade at this scale; both in px of the sketch.
constexpr double kThinnestStrokePx = 4;
constexpr double kOutlinePx = 8;

Result<Sketch> read_sketch_file(char const* path) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto drawing = read_svg(std::as_bytes(std::span(content)));
  if (!drawing) return drawing.error();
  for (auto& stroke : drawing->sketch.strokes)
    stroke.width_px = std::max(stroke.width_px, kThinnestStrokePx);
  return std::move(drawing->sketch);
}

/// One pair, its top left corner at the origin; empty when the file is refused.
DrawList draw_pair(char const* path) {
  auto const sketch = read_sketch_file(path);
  auto const drawing = sketch ? simplify(*sketch) : sketch.error();
  if (!drawing) {
    std::fprintf(stderr, "%s: %s\n", path, drawing.error().message.c_str());
    return {};
  }
  auto const scaling = Affine::scaling(kScale, kScale);
  auto pair = place(draw_sketch(*sketch), scaling);
  auto const result = draw_drawing(*drawing, {.line_width_px = kOutlinePx});
  append(pair, place(result, Affine::translation({kCellWidthPx, 0}) * scaling));
  return pair;
}

}  // namespace

int main(int count, char** arguments) {
  int const columns = count > 3 ? std::atoi(arguments[2]) : 0;
  if (columns < 1) {
    std::fprintf(stderr, "usage: contact_sheet OUT.png COLUMNS FILE.svg...\n");
    return 2;
  }
  DrawList sheet;
  bool is_done = true;
  double const pair_width_px = 2 * kCellWidthPx + kBetweenPairsPx;
  double const pair_height_px = kCellHeightPx + kBetweenPairsPx;
  for (int i = 0; i < count - 3; ++i) {
    auto pair = draw_pair(arguments[3 + i]);
    is_done = is_done && !pair.empty();
    Vec2 const corner = {kBetweenPairsPx + i % columns * pair_width_px,
                         kBetweenPairsPx + i / columns * pair_height_px};
    append(sheet, place(std::move(pair), Affine::translation(corner)));
  }
  int const rows = (count - 3 + columns - 1) / columns;
  auto const picture =
      rasterise(sheet, static_cast<int>(kBetweenPairsPx + columns * pair_width_px),
                static_cast<int>(kBetweenPairsPx + rows * pair_height_px), palette::kPaper);
  auto const png = write_png(picture);
  std::ofstream file(arguments[1], std::ios::binary);
  file.write(reinterpret_cast<char const*>(png.data()), std::ssize(png));
  return is_done && file.flush().good() ? 0 : 1;
}
