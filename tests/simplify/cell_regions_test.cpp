// SPDX-License-Identifier: Apache-2.0
#include "simplify/cell_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Sketch tic_tac_toe() {
  std::vector<Stroke> strokes = {line_stroke({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {0, 0}})};
  for (double const at : {300.0, 700.0}) {
    strokes.push_back(line_stroke({{0, at}, {1000, at}}));
    strokes.push_back(line_stroke({{at, 0}, {at, 1000}}));
  }
  return sketch_of(strokes);
}

TEST(JoinCells, TicTacToeHasNineWhiteRegions) {
  auto const cells = cells_of(tic_tac_toe());
  auto const labels = labels_of(cells);
  auto const whites = join_cells(cells, labels, 10);
  ASSERT_EQ(whites.regions.size(), 9U);
  std::vector<double> areas;
  for (auto const& region : whites.regions) {
    areas.push_back(region.area_px2);
    EXPECT_EQ(region.inner_ink_px, 0);
  }
  std::sort(areas.begin(), areas.end());
  // Four corners of 300 x 300, four sides of 300 x 400, the middle; cells at the ink may be missing.
  for (int i = 0; i < 9; ++i) {
    double const expected = i < 4 ? 90e3 : i < 8 ? 120e3 : 160e3;
    EXPECT_NEAR(areas[i], expected, 0.03 * expected);
  }
  auto const& middle = *std::max_element(
      whites.regions.begin(), whites.regions.end(),
      [](CellRegion const& a, CellRegion const& b) { return a.area_px2 < b.area_px2; });
  EXPECT_LT(distance(middle.centroid, Vec2{512, 512}), 5);
}

TEST(JoinCells, WithoutAPassageTheInsideIsOneWithAllItsInk) {
  auto const cells = cells_of(tic_tac_toe());
  auto const parts = join_cells(cells, labels_of(cells), 0);
  ASSERT_EQ(parts.regions.size(), 1U);
  EXPECT_NEAR(parts.regions[0].area_px2, 1e6, 100);
  EXPECT_NEAR(parts.regions[0].inner_ink_px, 4000, 50);
  EXPECT_LT(distance(parts.regions[0].centroid, Vec2{512, 512}), 0.1);
}

TEST(JoinCells, AGapBelowThePassageDoesNotJoin) {
  for (double const gap_px : {6.0, 30.0}) {
    auto const cells =
        cells_of(sketch_of({line_stroke({{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {0, 0}}),
                            line_stroke({{500, 0}, {500, 500 - gap_px / 2}}),
                            line_stroke({{500, 500 + gap_px / 2}, {500, 1000}})}));
    auto const whites = join_cells(cells, labels_of(cells), 10);
    EXPECT_EQ(whites.regions.size(), gap_px < 10 ? 2U : 1U);
  }
}

TEST(JoinCells, PartsAreCountedOnceAndTheirAreasSum) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    auto const cells = cells_of(random_sketch(seed), 15);
    auto const labels = random_labels(cells, rng);
    auto const parts = join_cells(cells, labels, 0);
    double area = 0;
    for (auto const& part : parts.regions) {
      area += part.area_px2;
      std::set<int> const corners(part.corners.begin(), part.corners.end());
      EXPECT_EQ(corners.size(), part.corners.size()) << seed;
    }
    EXPECT_NEAR(area, inside_area(cells, labels), 1e-3 * inside_area(cells, labels) + 1) << seed;
    for (int t = 0; t < cells.count(); ++t) {
      EXPECT_EQ(parts.of_cell[t] >= 0, labels[t] != 0);
      for (int e = 3 * t; e < 3 * t + 3; ++e) {
        int const twin = cells.twin(e);
        if (twin >= 0 && labels[t] != 0 && labels[twin / 3] != 0) {
          EXPECT_EQ(parts.of_cell[t], parts.of_cell[twin / 3]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace inkflate
