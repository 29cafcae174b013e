// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "simplify/cell_cut.h"

namespace inkflate {

/// Opens the enclosed white regions that were meant as holes. The cut fills every one of them: its rim is ink, which costs nothing inside.
/// A region is a hole when it is no speck, holds no ink, has hardly any of the silhouette at its rim, and is either
///   woven   enough of its rim was drawn by strokes that go on as the silhouette: a handle, a bay between arm and body, the eyes of a
///           pretzel. Eyes, buttons and belly patches have strokes of their own
///   a ring  its part holds no other ink, and the region is its part's middle or lies close under the silhouette
///
/// in      inside: labels of the cells; keep_inside: cells that the user marked as shape: their regions stay filled
/// out     the labels, with 0 in the holes' cells
/// cost    O(cells + samples)
/// source  docs/algorithms/simplify.md, "Holes"
CellLabels carve_holes(Cells const& cells, CellLabels inside, std::span<int const> keep_inside);

}  // namespace inkflate
