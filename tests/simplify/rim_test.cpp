// SPDX-License-Identifier: Apache-2.0
#include "simplify/rim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/crossings.h"
#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

using Edges = std::set<std::pair<int, int>>;

Edges edges_between_inside_and_outside(Cells const& cells, CellLabels const& inside) {
  Edges edges;
  for (int e = 0; e < 3 * cells.count(); ++e) {
    if (inside[e / 3] == 0) continue;
    if (cells.twin(e) >= 0 && inside[cells.twin(e) / 3] != 0) continue;
    edges.insert({cells.corner(e), cells.corner(next_half_edge(e))});
  }
  return edges;
}

/// Every law of the header.
void expect_rims(Sketch const& sketch, Cells const& cells, CellLabels const& inside) {
  auto const rims = trace_rims(sketch, cells, inside);
  Edges edges;
  double area = 0;
  std::vector<Contour> contours;
  for (auto const& rim : rims) {
    std::set<int> seen;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      EXPECT_TRUE(seen.insert(rim[i].sample).second);
      EXPECT_TRUE(edges.insert({rim[i].sample, rim[(i + 1) % rim.size()].sample}).second);
    }
    contours.push_back(positions(rim, cells.samples));
    EXPECT_TRUE(is_simple(contours.back()));
    area += signed_area(contours.back());
  }
  EXPECT_EQ(edges, edges_between_inside_and_outside(cells, inside));
  EXPECT_NEAR(area, inside_area(cells, inside), 1e-6);
  // Rims may share corners, but nothing else.
  for (auto const& crossing : find_crossings(contours, 10'000)) {
    auto const& a = rims[crossing.contour_a];
    auto const& b = rims[crossing.contour_b];
    int const a0 = a[crossing.edge_a].sample;
    int const a1 = a[(crossing.edge_a + 1) % std::ssize(a)].sample;
    int const b0 = b[crossing.edge_b].sample;
    int const b1 = b[(crossing.edge_b + 1) % std::ssize(b)].sample;
    EXPECT_TRUE(a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1);
  }
}

TEST(Rims, SeparateInsideFromOutsideWhateverTheLabels) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    auto const sketch = random_sketch(seed);
    auto const cells = cells_of(sketch, seed % 2 == 0 ? 40 : 9);
    expect_rims(sketch, cells, random_labels(cells, rng));
    expect_rims(sketch, cells, labels_of(cells));
  }
}

TEST(Rims, SliversDoNotFold) {
  // Almost parallel lines that meet in one point: rounding to the lattice moves samples to the other side of lines.
  std::vector<Stroke> strokes;
  for (int i = 0; i < 9; ++i) strokes.push_back(line_stroke({{0, 0}, {1000, 700 + i * 0.11}}));
  auto const sketch = sketch_of(strokes);
  auto const cells = cells_of(sketch);
  expect_rims(sketch, cells, CellLabels(static_cast<std::size_t>(cells.count()), 1));
  expect_rims(sketch, cells, labels_of(cells));
}

TEST(Rims, ARingHasAnOuterRimAndAHole) {
  auto const sketch = sketch_of({circle_stroke({500, 500}, 400), circle_stroke({500, 500}, 200)});
  auto const cells = cells_of(sketch);
  CellLabels inside(static_cast<std::size_t>(cells.count()), 0);
  for (int t = 0; t < cells.count(); ++t) {
    int small = 0;
    for (int e = 3 * t; e < 3 * t + 3; ++e)
      small += cells.samples.points[cells.corner(e)].stroke == 1 ? 1 : 0;
    inside[t] = small == 3 ? 0 : 1;
  }
  auto const rims = trace_rims(sketch, cells, inside);
  ASSERT_EQ(rims.size(), 2U);
  // The space is 1000 px for the 800 of the drawing.
  double const area = signed_area(positions(rims[0], cells.samples));
  double const other = signed_area(positions(rims[1], cells.samples));
  EXPECT_NEAR(std::max(area, other), M_PI * 500 * 500, 300);
  EXPECT_NEAR(std::min(area, other), -M_PI * 250 * 250, 300);
}

TEST(Rims, CellsThatMeetInACornerPart) {
  std::vector<Stroke> dots;
  for (Vec2 const p : {Vec2{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {500, 500}})
    dots.push_back(line_stroke({p}));
  auto const sketch = sketch_of(dots);
  auto const cells = cells_of(sketch);
  ASSERT_EQ(cells.count(), 4);
  CellLabels inside(4, 0);
  inside[find_cell(cells, {200, 512})] = 1;
  inside[find_cell(cells, {800, 512})] = 1;
  auto const rims = trace_rims(sketch, cells, inside);
  ASSERT_EQ(rims.size(), 2U);
  EXPECT_EQ(rims[0].size(), 3U);
  EXPECT_EQ(rims[1].size(), 3U);
}

TEST(Rims, EdgesAreInkHelpLineOrClosing) {
  auto const sketch =
      sketch_of({line_stroke({{0, 0}, {0, 600}, {600, 600}}), line_stroke({{600, 580}, {600, 0}}),
                 line_stroke({{600, 0}, {0, 0}}, StrokeKind::HelpLine)});
  auto const cells = cells_of(sketch);
  auto const rims = trace_rims(sketch, cells, labels_of(cells));
  ASSERT_EQ(rims.size(), 1U);
  auto const points = positions(rims[0], cells.samples);
  double lengths[3] = {};
  for (std::size_t i = 0; i < points.size(); ++i)
    lengths[static_cast<int>(rims[0][i].to_next)] +=
        distance(points[i], points[(i + 1) % points.size()]);
  double const scale = 1000.0 / 600;
  EXPECT_NEAR(lengths[static_cast<int>(RunKind::HelpLine)], 600 * scale, 5);
  EXPECT_NEAR(lengths[static_cast<int>(RunKind::Closing)], 20 * scale, 5);
  EXPECT_NEAR(lengths[static_cast<int>(RunKind::Ink)], 1780 * scale, 8);
}

TEST(Rims, NothingInsideHasNoRim) {
  auto const sketch = sketch_of({circle_stroke({500, 500}, 400)});
  auto const cells = cells_of(sketch, 50);
  EXPECT_TRUE(
      trace_rims(sketch, cells, CellLabels(static_cast<std::size_t>(cells.count()), 0)).empty());
  EXPECT_TRUE(trace_rims({}, make_cells({}), {}).empty());
}

}  // namespace
}  // namespace inkflate
