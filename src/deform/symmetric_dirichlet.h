// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/vec2.h"

namespace inkflate {

/// A triangle at rest, as its energy needs it.
struct RestTriangle {
  std::array<Vec2, 3> slopes;  // of the three hat functions, 1/px
  double inverse_cross = 0;    // 1 / twice the area, 1/px^2
  double weight = 0;           // stiffness times area, px^2
};

/// in      positive area
RestTriangle rest_triangle(std::array<Vec2, 3> const& rest, double stiffness);

/// The symmetric Dirichlet energy of a triangle that was mapped by J: weight (|J|^2 + |1/J|^2 - 4). 0 for a turn or shift, infinite where it has
/// no area or is turned over, never negative.
double dirichlet_energy(RestTriangle const& rest, std::array<Vec2, 3> const& places);

/// What a triangle's energy is nearby: a gradient, and a Hessian as a sum over four directions d, orthogonal to each other, of
/// curvature_d row_d row_d^T. The first two directions stretch along the axes of the map, the third turns, the fourth shears.
///
/// source  Smith, de Goes, Kim 2019, "Analytic Eigensystems for Isotropic Distortion Energies", in two dimensions
struct DirichletModel {
  /// Per direction and corner, 1/px: how the corner's move changes the direction.
  std::array<std::array<Vec2, 3>, 4> rows;
  /// px^2; > 0, but of the third: < 0 where a triangle is pressed together.
  std::array<double, 4> curvatures;
  std::array<double, 2> slopes;  // of the first two directions, px^2; of the others 0

  Vec2 gradient(int corner) const {
    return rows[0][corner] * slopes[0] + rows[1][corner] * slopes[1];
  }
};

/// in      a triangle of positive area
DirichletModel dirichlet_model(RestTriangle const& rest, std::array<Vec2, 3> const& places);

}  // namespace inkflate
