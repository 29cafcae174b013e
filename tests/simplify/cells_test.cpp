// SPDX-License-Identifier: Apache-2.0
#include "simplify/cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/predicates.h"
#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

TEST(Cells, LengthsAreThoseOfTheLatticeOnBothSides) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto const cells = cells_of(random_sketch(seed), 12);
    for (int e = 0; e < 3 * cells.count(); ++e) {
      auto const a = WorkSpace::lattice_position(cells.samples.lattice[cells.corner(e)]);
      auto const b =
          WorkSpace::lattice_position(cells.samples.lattice[cells.corner(next_half_edge(e))]);
      EXPECT_NEAR(cells.length_px(e), distance(a, b), 1e-9);
      if (cells.twin(e) >= 0) {
        EXPECT_EQ(cells.is_ink(e), cells.is_ink(cells.twin(e)));
      }
    }
  }
}

TEST(Cells, EveryStepOfAStrokeIsShortEnoughForInk) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto const cells = cells_of(random_sketch(seed));
    auto const& samples = cells.samples;
    for (std::size_t i = 1; i < samples.points.size(); ++i) {
      if (samples.points[i].stroke != samples.points[i - 1].stroke) continue;
      auto const a = samples.lattice[i - 1];
      auto const b = samples.lattice[i];
      EXPECT_LE((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y), cells.longest_ink_squared);
    }
  }
}

TEST(Cells, FindCellGivesTheTriangleAroundAPoint) {
  auto const cells = cells_of(random_sketch(5), 30);
  ASSERT_GT(cells.count(), 50);
  Rng rng(1);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    Vec2 const p = WorkSpace::lattice_position(
        WorkSpace::lattice_point({rng.uniform(-50, 1100), rng.uniform(-50, 1100)}));
    int const cell = find_cell(cells, p);
    for (int t = 0; t < cells.count(); ++t) {
      bool is_within = true;
      for (int e = 3 * t; e < 3 * t + 3; ++e) {
        auto const a = WorkSpace::lattice_position(cells.samples.lattice[cells.corner(e)]);
        auto const b =
            WorkSpace::lattice_position(cells.samples.lattice[cells.corner(next_half_edge(e))]);
        is_within &= orientation_sign(a, b, p) >= (t == cell ? 0 : 1);
      }
      EXPECT_EQ(is_within, t == cell);
    }
    found += cell >= 0 ? 1 : 0;
  }
  EXPECT_GT(found, 50);
}

TEST(Cells, FarPointsAreInNoCell) {
  auto const cells = cells_of(random_sketch(5), 30);
  for (double const far : {1e4, 1e9, 1e300, -1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(find_cell(cells, {far, 500}), -1);
    EXPECT_EQ(find_cell(cells, {500, far}), -1);
  }
  EXPECT_EQ(find_cell(make_cells({}), {0, 0}), -1);
}

}  // namespace
}  // namespace inkflate
