// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/vec2.h"
#include "mesh/tri_mesh.h"
#include "solvers/sparse_cholesky.h"

namespace inkflate {

/// What a plate's depth, or a slope of it, is at one place: a sum of nine unknowns with weights.
struct PlateRow {
  std::array<int, 9> nodes = {};  // numbers of unknowns
  std::array<double, 9> weights = {};

  double operator()(std::span<double const> unknowns) const {
    double sum = 0;
    for (int i = 0; i < 9; ++i) sum += weights[i] * unknowns[nodes[i]];
    return sum;
  }
};

/// How a plate resists: factors of integrals over the layer.
struct PlateStiffness {
  double bending = 1;  // > 0; of the squared second derivatives
  double slope = 0;    // per px^2; of the squared slopes
  double pull = 0;     // per px^4; of the squared depths
};

/// The smooth depth of one layer: a quadratic B-spline on a square lattice that is about eight cells long. It bends much more like
/// cardboard than a membrane would, has no kinks, and few unknowns.
class Plate {
 public:
  /// Numbers its unknowns from first on. mesh: at least one triangle.
  Plate(FlatMesh const& mesh, int first);

  double cell_px() const { return cell_px_; }
  /// Of the cells that the mesh touches.
  std::vector<Vec2> cell_centres() const;

  int unknown_count() const { return unknown_count_; }

  /// The depth at a point of the mesh; a point outside is moved to the nearest cell of the lattice.
  PlateRow depth(Vec2 p) const { return row(p, {0, 0}); }
  /// The slope along a direction of length 1.
  PlateRow slope(Vec2 p, Vec2 direction) const { return row(p, direction); }

  /// The quadratic form of its energy, as P-splines take it: differences of the coefficients instead of derivatives.
  /// point_areas: of the mesh
  void add_energy(FlatMesh const& mesh, std::vector<double> const& point_areas,
                  PlateStiffness const& stiffness, std::vector<MatrixEntry>& entries) const;

 private:
  int node_at(int x, int y) const;
  PlateRow row(Vec2 p, Vec2 direction) const;
  void add_bending(double factor, std::vector<MatrixEntry>& entries) const;
  void add_slopes(double weight, std::vector<MatrixEntry>& entries) const;

  int first_ = 0;
  Vec2 origin_;
  double cell_px_ = 1;
  int columns_ = 0;  // of cells
  int rows_ = 0;     // of cells
  std::vector<int>
      nodes_;  // (columns + 2) x (rows + 2); the number of the unknown, -1: of no use to the mesh
  int unknown_count_ = 0;
};

}  // namespace inkflate
