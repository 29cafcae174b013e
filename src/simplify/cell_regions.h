// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simplify/cells.h"

namespace inkflate {

/// Cells joined across their edges.
struct CellRegion {
  double area_px2 = 0;       // work px
  Vec2 centroid;             // work px
  double inner_ink_px = 0;   // length of the ink edges that have the region on both sides, work px
  std::vector<int> corners;  // the samples at the cells' corners, each once
};

struct CellRegions {
  std::vector<int>
      of_cell;  // per cell: its region; -1 for cells outside, and for those without a passage
  std::vector<CellRegion> regions;
};

/// Joins the cells labelled inside across edges longer than a passage. With a passage of 0: the separate parts of the inside. With
/// the width of a slip of the pen: the white regions between the strokes; the slivers between overdrawn strokes are in none.
///
/// in      inside: one label per cell; passage_px >= 0, work px
/// cost    O(cells)
CellRegions join_cells(Cells const& cells, std::span<std::uint8_t const> inside, double passage_px);

}  // namespace inkflate
