// SPDX-License-Identifier: Apache-2.0
#include "simplify/cell_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/cells.h"
#include "support/reference_max_flow.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// The energy as its definition has it, in 1/16 of a weight: ink asks for both its sides, paper costs where labels differ, and
/// beyond the hull all is outside.
struct Energy {
  std::vector<std::int64_t> ink;    // per cell: the price of being outside
  std::vector<std::int64_t> rim;    // per cell: the price of being inside
  std::vector<std::int64_t> paper;  // per half-edge with a twin: the price of unlike labels
};

Energy energy_of(Cells const& cells, double paper_weight, double longest_gap_px) {
  auto const count = static_cast<std::size_t>(cells.count());
  Energy energy = {std::vector<std::int64_t>(count), std::vector<std::int64_t>(count),
                   std::vector<std::int64_t>(3 * count)};
  for (int e = 0; e < 3 * cells.count(); ++e) {
    double const length = cells.length_px(e);
    if (cells.is_ink(e)) {
      energy.ink[e / 3] += std::llround(16 * 3 * length);
      continue;
    }
    auto const price =
        length > longest_gap_px ? std::int64_t{1} << 28 : std::llround(16 * paper_weight * length);
    (cells.twin(e) < 0 ? energy.rim[e / 3] : energy.paper[e]) += price;
  }
  return energy;
}

std::int64_t value(Energy const& energy, Cells const& cells, CellLabels const& labels) {
  std::int64_t sum = 0;
  for (int t = 0; t < cells.count(); ++t) sum += labels[t] == 0 ? energy.ink[t] : energy.rim[t];
  for (int e = 0; e < 3 * cells.count(); ++e) {
    if (labels[e / 3] != 0 && cells.twin(e) >= 0 && labels[cells.twin(e) / 3] == 0)
      sum += energy.paper[e];
  }
  return sum;
}

std::int64_t least_value(Energy const& energy, Cells const& cells) {
  int const source = cells.count();
  int const sink = source + 1;
  ReferenceMaxFlow flow(cells.count() + 2);
  for (int t = 0; t < cells.count(); ++t) {
    flow.add_arc(source, t, energy.ink[t]);
    flow.add_arc(t, sink, energy.rim[t]);
    for (int e = 3 * t; e < 3 * t + 3; ++e) {
      if (energy.paper[e] > 0) flow.add_arc(t, cells.twin(e) / 3, energy.paper[e]);
    }
  }
  return flow.solve(source, sink);
}

TEST(LabelCells, NoLabellingHasLessEnergy) {
  int with_inside = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    auto const cells = cells_of(random_sketch(seed), 45);
    if (cells.count() > 600) continue;
    CutOptions options;
    double longest_gap_px = 1e9;
    if (seed % 2 == 1) options.gap_px = longest_gap_px = 30.0 + 5.0 * static_cast<double>(seed);
    auto const labels = label_cells(cells, options);
    ASSERT_TRUE(labels.has_value());
    auto const energy = energy_of(cells, paper_weight_for_gap(options), longest_gap_px);
    EXPECT_EQ(value(energy, cells, *labels), least_value(energy, cells)) << seed;
    with_inside += std::accumulate(labels->begin(), labels->end(), 0) > 0 ? 1 : 0;
  }
  EXPECT_GT(with_inside, 5);
}

Sketch square_with_gap(double gap_px) {
  return sketch_of({line_stroke(
      {{500 - gap_px / 2, 0}, {0, 0}, {0, 1000}, {1000, 1000}, {1000, 0}, {500 + gap_px / 2, 0}})});
}

double inside_share(Sketch const& sketch, CutOptions const& options = {}) {
  auto const cells = cells_of(sketch);
  auto const labels = label_cells(cells, options);
  EXPECT_TRUE(labels.has_value());
  return labels ? inside_area(cells, *labels) / 1e6 : -1;
}

TEST(LabelCells, AGapClosesWhenSeventeenTimesItIsLessThanThreeTimesTheInk) {
  // 17 g = 3 (4000 - g) at g = 600.
  EXPECT_NEAR(inside_share(square_with_gap(590)), 1, 0.01);
  EXPECT_LT(inside_share(square_with_gap(610)), 0.1);
}

TEST(LabelCells, NoClosingIsLongerThanTheGap) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto const cells = cells_of(random_sketch(seed), 9);
    for (double const gap_px : {14.0, 60.0}) {
      CutOptions options;
      options.gap_px = gap_px;
      auto const labels = label_cells(cells, options);
      ASSERT_TRUE(labels.has_value());
      for (int e = 0; e < 3 * cells.count(); ++e) {
        bool const beyond = cells.twin(e) < 0 || (*labels)[cells.twin(e) / 3] == 0;
        if ((*labels)[e / 3] != 0 && beyond && !cells.is_ink(e)) {
          EXPECT_LE(cells.length_px(e), gap_px) << seed;
        }
      }
    }
  }
}

TEST(LabelCells, AnAllowedGapIsClosedWhateverTheInk) {
  EXPECT_NEAR(inside_share(square_with_gap(700), {.gap_px = 710, .outside = {}, .inside = {}}), 1,
              0.01);
  EXPECT_LT(inside_share(square_with_gap(700), {.gap_px = 690, .outside = {}, .inside = {}}), 0.1);
}

TEST(LabelCells, PaperGetsCheaperForLongerGapsDownToALimit) {
  CutOptions options;
  EXPECT_EQ(paper_weight_for_gap(options), options.paper_weight);
  double last = options.paper_weight;
  for (double gap_px = 1; gap_px < 2000; gap_px *= 1.3) {
    options.gap_px = gap_px;
    double const weight = paper_weight_for_gap(options);
    EXPECT_LE(weight, last);
    EXPECT_GT(weight, std::sqrt(2.0) * options.ink_weight);  // corners stay
    last = weight;
  }
  EXPECT_LT(last, options.paper_weight / 2);
}

TEST(LabelCells, MarksHold) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Rng rng(seed);
    auto const cells = cells_of(random_sketch(seed), 20);
    if (cells.count() == 0) continue;
    auto const centre = [&](int t) {
      Vec2 sum;
      for (int e = 3 * t; e < 3 * t + 3; ++e)
        sum += WorkSpace::lattice_position(cells.samples.lattice[cells.corner(e)]);
      return sum / 3;
    };
    int const marked = rng.below(cells.count());
    auto const mark = centre(marked);
    int const cell = find_cell(cells, mark);  // rounding may take a sliver's centre to a neighbour
    CutOptions inside;
    inside.inside = {mark};
    auto const filled = label_cells(cells, inside);
    ASSERT_TRUE(filled.has_value());
    EXPECT_EQ((*filled)[cell], 1) << seed;
    CutOptions outside;
    outside.outside = {mark};
    auto const opened = label_cells(cells, outside);
    ASSERT_TRUE(opened.has_value());
    EXPECT_EQ((*opened)[cell], 0) << seed;
  }
}

TEST(LabelCells, AnInsideMarkBeyondTheStrokesIsRefusedAnOutsideMarkIsNot) {
  auto const cells = cells_of(sketch_of({circle_stroke({500, 500}, 300)}));
  CutOptions options;
  options.inside = {{512, 512}, {1011, 1011}};
  auto const refused = label_cells(cells, options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::BadOption);
  EXPECT_EQ(refused.error().index, 1);
  options = {};
  options.outside = {{1011, 1011}};
  EXPECT_EQ(*label_cells(cells, options), labels_of(cells));
}

TEST(LabelCells, NoCellsHaveNoLabels) { EXPECT_TRUE(labels_of(make_cells({})).empty()); }

}  // namespace
}  // namespace inkflate
