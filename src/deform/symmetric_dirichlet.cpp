// SPDX-License-Identifier: Apache-2.0
#include "deform/symmetric_dirichlet.h"

#include <limits>

#include "geometry/complex.h"

namespace inkflate {
namespace {

constexpr double kInverseRoot2 = 0.70710678118654752440;

/// A map of the plane J as z -> turning z + folding conj(z), and its determinant.
struct ComplexMap {
  Vec2 turning;
  Vec2 folding;
  double determinant = 0;
};

ComplexMap map_of(RestTriangle const& rest, std::array<Vec2, 3> const& places) {
  Vec2 const u = places[1] - places[0];
  Vec2 const v = places[2] - places[0];
  Vec2 const g = rest.slopes[1];
  Vec2 const h = rest.slopes[2];
  return {(product(u, conjugate(g)) + product(v, conjugate(h))) * 0.5,
          (product(u, g) + product(v, h)) * 0.5,
          // Not |turning|^2 - |folding|^2, which cancels where a triangle is thin.
          cross(u, v) * rest.inverse_cross};
}

}  // namespace

RestTriangle rest_triangle(std::array<Vec2, 3> const& rest, double stiffness) {
  double const twice_area = cross(rest[1] - rest[0], rest[2] - rest[0]);
  RestTriangle result;
  for (int i = 0; i < 3; ++i) {
    Vec2 const opposite = rest[(i + 2) % 3] - rest[(i + 1) % 3];
    result.slopes[i] = perpendicular(opposite) / twice_area;
  }
  result.inverse_cross = 1 / twice_area;
  result.weight = stiffness * twice_area / 2;
  return result;
}

double dirichlet_energy(RestTriangle const& rest, std::array<Vec2, 3> const& places) {
  auto const map = map_of(rest, places);
  double const d = map.determinant;
  bool const is_upright = d > 0;
  if (!is_upright) return std::numeric_limits<double>::infinity();
  // |J|^2 (1 + 1/d^2) - 4 with |J|^2 = 4 |folding|^2 + 2 d: both terms are exactly 0 at rest.
  return rest.weight *
         (4 * squared_norm(map.folding) * (1 + 1 / (d * d)) + 2 * (d - 1) * (d - 1) / d);
}

DirichletModel dirichlet_model(RestTriangle const& rest, std::array<Vec2, 3> const& places) {
  auto const map = map_of(rest, places);
  double const turning = norm(map.turning);
  double const folding = norm(map.folding);
  double const d = map.determinant;
  double const large = turning + folding;  // the singular values
  double const small = d / large;
  double const inverse_cube = 1 / (d * d * d);
  double const sum = large * large + small * small;

  DirichletModel model;
  auto const slope = [](double s) { return 2 * (s - 1 / (s * s * s)); };
  auto const curvature = [](double s) { return 2 + 6 / (s * s * s * s); };
  model.slopes = {rest.weight * slope(large), rest.weight * slope(small)};
  model.curvatures = {rest.weight * curvature(large), rest.weight * curvature(small),
                      rest.weight * (2 - 2 * (sum - d) * inverse_cube),
                      rest.weight * (2 + 2 * (sum + d) * inverse_cube)};

  Vec2 const turn = conjugate(map.turning) * (kInverseRoot2 / turning);
  // Where nothing is folded, the direction does not matter: both that it takes part in have the same curvature.
  Vec2 const fold =
      folding > 0 ? conjugate(map.folding) * (kInverseRoot2 / folding) : Vec2{kInverseRoot2, 0};
  for (int i = 0; i < 3; ++i) {
    Vec2 const s = product(conjugate(rest.slopes[i]), turn);
    Vec2 const t = product(rest.slopes[i], fold);
    model.rows[0][i] = conjugate(s + t) * kInverseRoot2;
    model.rows[1][i] = conjugate(s - t) * kInverseRoot2;
    model.rows[2][i] = {s.y, s.x};
    model.rows[3][i] = {t.y, t.x};
  }
  return model;
}

}  // namespace inkflate
