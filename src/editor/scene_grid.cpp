// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_grid.h"

#include <cmath>
#include <memory>
#include <utility>

#include "render/palette.h"

namespace inkflate {
namespace {

constexpr double kLeastSpacingOnScreenPx = 20;
constexpr int kStrongEvery = 10;
/// Ranges are rounded outwards to multiples of this.
constexpr int kBlock = 10;
constexpr double kHairlinePx = 1;

double spacing_px(double zoom) {
  double spacing = 1e-3;
  for (int i = 0; spacing * zoom < kLeastSpacingOnScreenPx; ++i) spacing *= i % 2 == 0 ? 5 : 2;
  return spacing;
}

int block_below(double place_px, double spacing) {
  return kBlock * static_cast<int>(std::floor(place_px / spacing / kBlock));
}

int block_above(double place_px, double spacing) {
  return kBlock * static_cast<int>(std::ceil(place_px / spacing / kBlock));
}

}  // namespace

GridLines grid_lines(Camera const& camera, ViewSize const& size) {
  double const spacing = spacing_px(camera.zoom);
  Vec2 const half = Vec2{size.width_px, size.height_px} / (2 * camera.zoom);
  return {spacing, block_below(camera.centre.x - half.x, spacing),
          block_above(camera.centre.x + half.x, spacing),
          block_below(camera.centre.y - half.y, spacing),
          block_above(camera.centre.y + half.y, spacing)};
}

DrawList draw_grid(GridLines const& grid) {
  DrawList list;
  auto const place = [&](int number) { return number * grid.spacing_px; };
  auto const add = [&](int number, Vec2 from, Vec2 to) {
    Colour const colour = number % kStrongEvery == 0 ? palette::kStrongGrid : palette::kGrid;
    list.push_back(
        StrokedPolyline{{from, to}, {kHairlinePx}, {}, colour, {kHairlinePx, kHairlinePx}});
  };
  for (int x = grid.left; x <= grid.right; ++x) {
    add(x, {place(x), place(grid.top)}, {place(x), place(grid.bottom)});
  }
  for (int y = grid.top; y <= grid.bottom; ++y) {
    add(y, {place(grid.left), place(y)}, {place(grid.right), place(y)});
  }
  return list;
}

SceneChunk const& GridChunk::update(GridLines const& grid, std::uint64_t& next_id) {
  if (!chunk_.list || !(grid == grid_)) {
    chunk_ = {next_id++, SceneSpace::Canvas, std::make_shared<DrawList const>(draw_grid(grid))};
    grid_ = grid;
  }
  return chunk_;
}

}  // namespace inkflate
