// SPDX-License-Identifier: Apache-2.0
#include "inflate/plate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "inflate/point_areas.h"
#include "support/flat_meshes.h"

namespace inkflate {
namespace {

/// A plate and unknowns for which it has given depths at the mesh's points, as nearly as it can.
struct Fitted {
  FlatLayer layer;
  Plate plate;
  std::vector<double> unknowns;
};

template <typename Depth>
Fitted fit(Depth depth, double bending) {
  Fitted f = {support::disc_layer({100, 60}, 80, 12), Plate(FlatMesh{}, 0), {}};
  f.plate = Plate(f.layer.mesh, 0);
  f.unknowns.assign(f.plate.unknown_count(), 0);
  std::vector<MatrixEntry> entries;
  f.plate.add_energy(f.layer.mesh, point_areas(f.layer.mesh), {bending, 0, 0}, entries);
  for (auto const p : f.layer.mesh.points) {
    auto const row = f.plate.depth(p);
    for (int i = 0; i < 9; ++i) {
      f.unknowns[row.nodes[i]] += row.weights[i] * depth(p);
      for (int j = 0; j < 9; ++j) {
        if (row.nodes[i] < row.nodes[j]) continue;
        entries.push_back({row.nodes[i], row.nodes[j], row.weights[i] * row.weights[j]});
      }
    }
  }
  SparseCholesky::factor(f.plate.unknown_count(), entries).value().solve(f.unknowns);
  return f;
}

double energy(Fitted const& f, PlateStiffness const& stiffness) {
  std::vector<MatrixEntry> entries;
  f.plate.add_energy(f.layer.mesh, point_areas(f.layer.mesh), stiffness, entries);
  double sum = 0;
  for (auto const& e : entries) {
    sum += e.value * f.unknowns[e.row] * f.unknowns[e.column] * (e.row == e.column ? 1 : 2);
  }
  return sum;
}

TEST(Plate, APlaneCostsNoBending) {
  auto const f = fit([](Vec2 p) { return 5 + 0.5 * p.x - 0.25 * p.y; }, 1000);
  for (auto const p : f.layer.mesh.points) {
    EXPECT_NEAR(f.plate.depth(p)(f.unknowns), 5 + 0.5 * p.x - 0.25 * p.y, 1e-3);
  }
  EXPECT_NEAR(energy(f, {1, 0, 0}), 0, 1e-4);
}

TEST(Plate, SlopesOfAPlaneAreItsSlopes) {
  auto const f = fit([](Vec2 p) { return 5 + 0.5 * p.x - 0.25 * p.y; }, 1000);
  EXPECT_NEAR(f.plate.slope({90, 70}, {1, 0})(f.unknowns), 0.5, 1e-5);
  EXPECT_NEAR(f.plate.slope({120, 33}, {0.6, -0.8})(f.unknowns), 0.5, 1e-5);
}

TEST(Plate, ABowlCostsItsSquaredCurvatureTimesItsArea) {
  // Depth k r^2 / 2: second derivatives k, k and 0; over the lattice's nodes, which reach beyond the disc.
  auto const f = fit([](Vec2 p) { return 0.01 * squared_norm(p - Vec2{100, 60}) / 2; }, 1e-6);
  double const disc = 2 * 0.01 * 0.01 * kPi * 80 * 80;
  EXPECT_GT(energy(f, {1, 0, 0}), disc);
  EXPECT_LT(energy(f, {1, 0, 0}), 2 * disc);
}

TEST(Plate, PullCostsTheSquaredDepthTimesTheArea) {
  auto const f = fit([](Vec2) { return 3.0; }, 1000);
  double const area = kPi * 80 * 80;
  EXPECT_NEAR(energy(f, {1, 0, 2}) / (2 * 9 * area), 1, 0.01);
}

TEST(Plate, ABigLayerHasNoMoreUnknownsThanASmallOne) {
  auto const small = support::disc_layer({0, 0}, 100, 20);
  auto const large = support::disc_layer({0, 0}, 5000, 20);
  EXPECT_EQ(Plate(small.mesh, 0).unknown_count(), Plate(large.mesh, 0).unknown_count());
}

}  // namespace
}  // namespace inkflate
