// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "mesh/delaunay.h"
#include "simplify/stroke_samples.h"

namespace inkflate {

/// The energy of thesis eq. 3.4 read as geometry: what one px of outline costs.
struct CutOptions {
  double ink_weight = 3;     // > 0; where it runs along ink (thesis 5.4.2)
  double paper_weight = 17;  // >= ink_weight; where it crosses paper (thesis 5.4.2)
  std::optional<double>
      gap_px;  // > 0, frame px: paper as cheap as ink up to this length, never crossed above it
  std::vector<Vec2> outside;  // frame px; the cells that hold these are background
  std::vector<Vec2> inside;   // frame px; the cells that hold these belong to the shape
};

/// Labels each triangle of the samples' Delaunay triangulation 1 (inside) or 0, at the least energy: ink pulls the cells on both
/// its sides inside, paper resists the outline that crosses it. Exact: one minimum cut.
///
/// in      samples, mesh = delaunay(samples.lattice)
/// errors  BadOption (an inside mark beyond the hull of the strokes)
/// cost    near linear in the number of cells; about 0.15 us each
/// source  thesis section 3.2; docs/algorithms/simplify.md, "The cut"
Result<std::vector<std::uint8_t>> label_cells(StrokeSamples const& samples,
                                              Triangulation const& mesh, CutOptions const& options);

/// The cell that holds p (frame px), its rim included; -1 beyond the hull. O(cells): for marks, of which there are few.
int find_cell(StrokeSamples const& samples, Triangulation const& mesh, Vec2 p);

/// An edge no longer than this is ink: the strokes' own steps, and the short bridges between overdrawn ones. Lattice units, squared.
std::int64_t longest_ink_edge_squared(StrokeSamples const& samples);

/// The squared length of a half-edge, lattice units.
std::int64_t squared_length(StrokeSamples const& samples, Triangulation const& mesh, int half_edge);

}  // namespace inkflate
