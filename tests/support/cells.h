// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numeric>
#include <vector>

#include "base/rng.h"
#include "simplify/cell_cut.h"

namespace inkflate {

/// The steps from a sketch to its cells, for tests of what comes after them.

inline std::vector<int> all_strokes(Sketch const& sketch) {
  std::vector<int> all(sketch.strokes.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

inline WorkSpace space_of(Sketch const& sketch) {
  Rect box;
  for (auto const& stroke : sketch.strokes) {
    for (auto const& sample : stroke.samples) box.include(sample.position);
  }
  return WorkSpace::around(box);
}

inline StrokeSamples samples_of(Sketch const& sketch, double spacing_px = 2.2) {
  return sample_strokes(sketch, all_strokes(sketch), space_of(sketch), spacing_px);
}

inline Cells cells_of(Sketch const& sketch, double spacing_px = 2.2) {
  return make_cells(samples_of(sketch, spacing_px));
}

inline double cell_area(Cells const& cells, int t) {
  auto const a = cells.samples.lattice[cells.corner(3 * t)];
  auto const b = cells.samples.lattice[cells.corner(3 * t + 1)];
  auto const c = cells.samples.lattice[cells.corner(3 * t + 2)];
  return static_cast<double>(orientation(a, b, c)) /
         (2.0 * WorkSpace::kLatticePerPx * WorkSpace::kLatticePerPx);
}

inline double inside_area(Cells const& cells, CellLabels const& inside) {
  double sum = 0;
  for (int t = 0; t < cells.count(); ++t) sum += inside[t] != 0 ? cell_area(cells, t) : 0;
  return sum;
}

/// The labels that the energy gives without any option.
inline CellLabels labels_of(Cells const& cells) { return *label_cells(cells, {}); }

/// Labels that no energy would give: lumps of random cells.
inline CellLabels random_labels(Cells const& cells, Rng& rng) {
  CellLabels labels(static_cast<std::size_t>(cells.count()), 0);
  double const share = rng.uniform(0.1, 0.9);
  for (auto& label : labels) label = rng.uniform() < share ? 1 : 0;
  return labels;
}

}  // namespace inkflate
