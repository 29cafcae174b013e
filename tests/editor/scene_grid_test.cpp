// SPDX-License-Identifier: Apache-2.0
#include "editor/scene_grid.h"

#include <gtest/gtest.h>

#include "base/rng.h"

namespace inkflate {
namespace {

TEST(SceneGrid, LinesAreNeitherDenseNorFarApart) {
  for (double zoom = Camera::kLeastZoom; zoom <= Camera::kLargestZoom; zoom *= 1.01) {
    Camera camera;
    camera.zoom = zoom;
    double const spacing_px = zoom * grid_lines(camera, {}).spacing_px;
    EXPECT_GE(spacing_px, 20 - 1e-9);
    EXPECT_LE(spacing_px, 100 + 1e-9);
  }
}

TEST(SceneGrid, LinesFillTheViewAndLittleMore) {
  Rng rng(5);
  for (int i = 0; i < 200; ++i) {
    Camera camera;
    camera.centre = {rng.uniform(-1e6, 1e6), rng.uniform(-1e6, 1e6)};
    camera.zoom = rng.uniform(0.02, 64);
    ViewSize const size = {rng.uniform(0, 2000), rng.uniform(0, 2000)};
    auto const grid = grid_lines(camera, size);
    double const half = size.width_px / 2 / camera.zoom;
    EXPECT_LE(grid.left * grid.spacing_px, camera.centre.x - half + 1e-6);
    EXPECT_GE(grid.right * grid.spacing_px, camera.centre.x + half - 1e-6);
    EXPECT_LE(grid.right - grid.left, 2 * half / grid.spacing_px + 20);
    EXPECT_LE(grid.bottom - grid.top, size.height_px / camera.zoom / grid.spacing_px + 20);
    auto const lines = grid.right - grid.left + grid.bottom - grid.top + 2;
    EXPECT_EQ(static_cast<int>(draw_grid(grid).size()), lines);
  }
}

}  // namespace
}  // namespace inkflate
