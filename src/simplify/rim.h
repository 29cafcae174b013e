// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/drawing.h"
#include "simplify/cell_cut.h"

namespace inkflate {

/// A corner of a rim: a stroke sample, and what the edge to the next corner is.
struct RimPoint {
  int sample = 0;
  RunKind to_next = RunKind::Ink;

  friend bool operator==(RimPoint const&, RimPoint const&) = default;
};

/// A closed polygon through stroke samples; no sample twice, no self-crossing. Outer rims have positive area, holes negative.
using Rim = std::vector<RimPoint>;

/// The rims of the cells labelled inside. Where cells meet only in a corner, the rims part.
///
/// out     every rim once, outer ones and holes
/// cost    O(cells)
std::vector<Rim> trace_rims(Sketch const& sketch, Cells const& cells, CellLabels const& inside);

/// The corner positions, work px: as rounded to the lattice, for thin places may fold where the samples themselves are.
Contour positions(Rim const& rim, StrokeSamples const& samples);

}  // namespace inkflate
