// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "editor/scene_chunk.h"
#include "editor/view.h"

namespace inkflate {

/// Which lines of the paper a view needs: those whose number lies in a range, number times spacing from the origin.
struct GridLines {
  double spacing_px =
      0;         // canvas px; one of ..., 1, 5, 10, 50, 100, ...: 20 .. 100 px on the screen
  int left = 0;  // numbers, rounded outwards so that panning seldom changes them
  int right = 0;
  int top = 0;
  int bottom = 0;

  friend bool operator==(GridLines const&, GridLines const&) = default;
};

/// in      a finite view, its zoom within the camera's limits
GridLines grid_lines(Camera const& camera, ViewSize const& size);

/// Hairlines; every tenth a little stronger.
DrawList draw_grid(GridLines const& grid);

/// The chunk of the paper's lines, kept from scene to scene.
class GridChunk {
 public:
  SceneChunk const& update(GridLines const& grid, std::uint64_t& next_id);

 private:
  GridLines grid_;
  SceneChunk chunk_;
};

}  // namespace inkflate
