// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/delaunay.h"
#include "simplify/stroke_samples.h"

namespace inkflate {

/// The plane between the strokes: the triangles of the samples' Delaunay triangulation are the cells, their half-edges are either ink (a
/// stroke's own step, or the short bridge between overdrawn strokes) or paper.
struct Cells {
  StrokeSamples samples;
  Triangulation mesh;
  std::vector<std::int32_t> squared_lengths;  // per half-edge, lattice units; below 2^30
  std::int32_t longest_ink_squared = 0;       // no longer half-edge is ink

  int count() const { return mesh.triangle_count(); }
  int corner(int half_edge) const { return mesh.corners[half_edge]; }
  /// The half-edge on the other side; -1 on the hull.
  int twin(int half_edge) const { return mesh.twins[half_edge]; }
  bool is_ink(int half_edge) const { return squared_lengths[half_edge] <= longest_ink_squared; }
  /// Whether it lies on a chord: an outline along it costs nothing.
  bool is_chord(int half_edge) const {
    return samples.is_chord(corner(half_edge)) ||
           samples.is_chord(corner(next_half_edge(half_edge)));
  }
  /// Work px.
  double length_px(int half_edge) const {
    return std::sqrt(static_cast<double>(squared_lengths[half_edge])) / WorkSpace::kLatticePerPx;
  }
  /// Of a sample, work px.
  Vec2 position(int sample) const { return samples.points[sample].position; }
};

/// cost    that of delaunay
Cells make_cells(StrokeSamples samples);

/// The cell that holds p (work px), its rim included; -1 beyond the hull. O(cells): for marks, of which there are few.
int find_cell(Cells const& cells, Vec2 p);

}  // namespace inkflate
