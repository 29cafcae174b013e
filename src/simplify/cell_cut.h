// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.h"
#include "simplify/cells.h"

namespace inkflate {

/// One label per cell: 1 inside, 0 outside.
using CellLabels = std::vector<std::uint8_t>;

/// The energy of thesis eq. 3.4 read as geometry: what one px of outline costs.
struct CutOptions {
  double ink_weight = 3;     // > 0; where it runs along ink (thesis 5.4.2)
  double paper_weight = 17;  // >= ink_weight; where it crosses paper (thesis 5.4.2)
  std::optional<double>
      gap_px;  // > 0, work px: paper as cheap as ink up to this length, never crossed above it
  std::vector<Vec2> outside;  // work px; the cells that hold these are background
  std::vector<Vec2> inside;   // work px; the cells that hold these belong to the shape
};

/// What paper costs per px when gaps may be so long: at most paper_weight; for long gaps less, so that a gap of that length pays for
/// a shape some 200 work px across. Never so little that corners of 90 degrees are cut.
double paper_weight_for_gap(CutOptions const& options);

/// Labels the cells at the least energy: ink pulls the cells on both its sides inside, paper resists the outline that crosses it.
/// Exact: one minimum cut.
///
/// Marks are terminal links (as the scribbles of LazyBrush, Sykora et al. 2009) on the cells that a person means by a click.
///
/// errors  BadOption (an inside mark beyond the hull of the strokes)
/// cost    near linear in the number of cells; about 0.1 us each
/// source  thesis section 3.2; docs/algorithms/simplify.md, "The cut"
Result<CellLabels> label_cells(Cells const& cells, CutOptions const& options);

}  // namespace inkflate
