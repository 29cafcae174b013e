// SPDX-License-Identifier: Apache-2.0
#include "simplify/cells.h"

#include <utility>

namespace inkflate {
namespace {

std::int32_t squared_distance(LatticePoint a, LatticePoint b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

}  // namespace

Cells make_cells(StrokeSamples samples) {
  Cells cells;
  cells.mesh = delaunay(samples.lattice);
  // Rounding to the lattice moves each end of a step by at most half a unit along each axis.
  double const longest = samples.spacing_px * WorkSpace::kLatticePerPx + 1.5;
  cells.longest_ink_squared = static_cast<std::int32_t>(longest * longest);
  cells.squared_lengths.resize(cells.mesh.corners.size());
  for (int e = 0; e < std::ssize(cells.mesh.corners); ++e) {
    auto const a = samples.lattice[cells.mesh.corners[e]];
    auto const b = samples.lattice[cells.mesh.corners[next_half_edge(e)]];
    cells.squared_lengths[e] = squared_distance(a, b);
  }
  cells.samples = std::move(samples);
  return cells;
}

int find_cell(Cells const& cells, Vec2 p) {
  auto const corner = [&](int e) { return cells.samples.lattice[cells.corner(e)]; };
  double const far = 2.0 * kLatticeSize / WorkSpace::kLatticePerPx;
  if (std::abs(p.x) > far || std::abs(p.y) > far)
    return -1;  // off the lattice by more than products may be
  auto const lattice = WorkSpace::lattice_point(p);
  for (int t = 0; t < cells.count(); ++t) {
    auto const a = corner(3 * t);
    auto const b = corner(3 * t + 1);
    auto const c = corner(3 * t + 2);
    if (orientation(a, b, lattice) >= 0 && orientation(b, c, lattice) >= 0 &&
        orientation(c, a, lattice) >= 0) {
      return t;
    }
  }
  return -1;
}

}  // namespace inkflate
