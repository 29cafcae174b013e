// SPDX-License-Identifier: Apache-2.0
// model_sheet OUT.png COLUMNS FILE.svg...: rough drawings, each with its layers and the model from two sides.
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
#include "pipeline/run_inflate.h"
#include "pipeline/run_simplify.h"
#include "render/bake_texture.h"
#include "render/draw_drawing.h"
#include "render/palette.h"
#include "render/rasterise.h"
#include "render/rasterise_model.h"

namespace {

using namespace inkflate;

// Canvases are 1000 x 800 px.
constexpr double kScale = 0.26;
constexpr int kCellWidth = 260;
constexpr int kCellHeight = 208;
constexpr int kBetween = 20;
// Thinner ones would fade at this scale; both in px of the sketch.
constexpr double kThinnestStrokePx = 4;
constexpr double kOutlinePx = 7;
// The characters look to the left: from there, and from behind.
constexpr ModelView kFromTheFront = {-0.55, 0.2, 1.06, {}};
constexpr ModelView kFromBehind = {2.5, 0.2, 1.06, {}};

struct Cells {
  DrawList rough;
  DrawList layers;
  Picture front;
  Picture back;
};

Result<Cells> cells_of(char const* path) {
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> const content{std::istreambuf_iterator<char>(stream), {}};
  auto const read = read_svg(std::as_bytes(std::span(content)));
  if (!read) return read.error();
  RunSimplifyOptions options;
  options.simplify.parts = Parts::Groups;
  auto const drawing = run_simplify(read->sketch, options);
  if (!drawing) return drawing.error();
  auto const model = run_inflate(*drawing);
  if (!model) return model.error();
  auto const texture = bake_texture(*drawing, *model);
  auto sketch = read->sketch;
  for (auto& stroke : sketch.strokes)
    stroke.width_px = std::max(stroke.width_px, kThinnestStrokePx);
  auto const scaling = Affine::scaling(kScale, kScale);
  auto const picture = [&](ModelView const& view) {
    auto const list =
        draw_model(*model, &texture, view, Shading::Textured, kCellWidth, kCellHeight);
    return rasterise_model(list, kCellWidth, kCellHeight, {palette::kPaper, GroundShadow::On});
  };
  return Cells{place(draw_sketch(sketch), scaling),
               place(draw_drawing(*drawing, {.line_width_px = kOutlinePx}), scaling),
               picture(kFromTheFront), picture(kFromBehind)};
}

void put(Picture const& cell, int left, int top, Picture& sheet) {
  for (int y = 0; y < cell.height; ++y) {
    for (int x = 0; x < cell.width; ++x) sheet.at(left + x, top + y) = cell.at(x, y);
  }
}

void put(DrawList const& cell, int left, int top, Picture& sheet) {
  Vec2 const corner = {static_cast<double>(left), static_cast<double>(top)};
  rasterise_into(place(cell, Affine::translation(corner)), {left, top, kCellWidth, kCellHeight},
                 sheet);
}

}  // namespace

int main(int count, char** arguments) {
  int const columns = count > 3 ? std::atoi(arguments[2]) : 0;
  if (columns < 1) {
    std::fprintf(stderr, "usage: model_sheet OUT.png COLUMNS FILE.svg...\n");
    return 2;
  }
  int const rows = (count - 3 + columns - 1) / columns;
  int const wide = 4 * kCellWidth + 2 * kBetween;
  int const high = kCellHeight + kBetween;
  Picture sheet(columns * wide, rows * high + kBetween, palette::kPaper);
  bool is_done = true;
  for (int i = 0; i < count - 3; ++i) {
    auto const cells = cells_of(arguments[3 + i]);
    if (!cells) {
      std::fprintf(stderr, "%s: %s\n", arguments[3 + i], cells.error().message.c_str());
      is_done = false;
      continue;
    }
    int const left = i % columns * wide + kBetween;
    int const top = i / columns * high + kBetween;
    put(cells->rough, left, top, sheet);
    put(cells->layers, left + kCellWidth, top, sheet);
    put(cells->front, left + 2 * kCellWidth, top, sheet);
    put(cells->back, left + 3 * kCellWidth, top, sheet);
  }
  auto const png = write_png(sheet);
  std::ofstream file(arguments[1], std::ios::binary);
  file.write(reinterpret_cast<char const*>(png.data()), std::ssize(png));
  return is_done && file.flush().good() ? 0 : 1;
}
