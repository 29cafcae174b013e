// SPDX-License-Identifier: Apache-2.0
#include "simplify/carve_holes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simplify/simplify.h"
#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

/// The holes of the largest layer.
std::vector<Outline> holes_of(std::vector<Stroke> strokes, SimplifyOptions const& options = {}) {
  auto const drawing = simplify(sketch_of(std::move(strokes)), options);
  EXPECT_TRUE(drawing.has_value());
  if (!drawing) return {};
  EXPECT_EQ(what_is_wrong(*drawing), "");
  auto const& outlines = drawing->layers[0].outlines;
  return {outlines.begin() + 1, outlines.end()};
}

double area(Outline const& outline) { return -signed_area(flatten(outline, 0.1)); }

std::vector<Stroke> ring() {
  return {circle_stroke({500, 500}, 400), circle_stroke({500, 500}, 200)};
}

/// A mug whose handle is two arcs that end on its wall.
std::vector<Stroke> mug() {
  return {line_stroke({{200, 150}, {200, 850}, {600, 850}, {600, 150}, {200, 150}}),
          arc_stroke({600, 500}, 260, 260, -M_PI / 2, M_PI / 2),
          arc_stroke({600, 500}, 190, 190, -M_PI / 2, M_PI / 2)};
}

TEST(CarveHoles, TwoConcentricCirclesAreARing) {
  auto const holes = holes_of(ring());
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_NEAR(area(holes[0]), M_PI * 200 * 200, 0.02 * M_PI * 200 * 200);
}

TEST(CarveHoles, ARingStaysOneWhenItIsDrawnOver) {
  std::vector<Stroke> strokes;
  for (double const aside_px : {0.0, 3.0, 5.0}) {
    strokes.push_back(circle_stroke({500, 500 + aside_px}, 400));
    strokes.push_back(circle_stroke({500 + aside_px, 500}, 200));
  }
  auto const holes = holes_of(strokes);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_NEAR(area(holes[0]), M_PI * 200 * 200, 0.05 * M_PI * 200 * 200);
}

TEST(CarveHoles, TheHandleOfAMugIsOpen) {
  auto const holes = holes_of(mug());
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_NEAR(area(holes[0]), M_PI * 190 * 190 / 2, 0.05 * M_PI * 190 * 190 / 2);
}

TEST(CarveHoles, AnArmAkimboKeepsItsBay) {
  // Body and arm are drawn in one go each; between them the arm's inner line meets the body twice.
  auto const holes =
      holes_of({line_stroke({{350, 100}, {350, 900}, {650, 900}, {650, 700}}),
                line_stroke({{350, 100}, {650, 100}, {650, 250}, {900, 470}, {650, 700}}),
                line_stroke({{650, 320}, {820, 470}, {650, 620}, {650, 310}}),
                line_stroke({{450, 200}, {550, 200}})});
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_NEAR(area(holes[0]), 170.0 * 300 / 2, 0.1 * 170 * 300 / 2);
}

TEST(CarveHoles, AFaceHasNone) {
  EXPECT_TRUE(holes_of({circle_stroke({500, 500}, 400), circle_stroke({350, 400}, 60),
                        circle_stroke({650, 400}, 60), arc_stroke({500, 600}, 200, 120, 0, M_PI),
                        line_stroke({{300, 600}, {700, 600}})})
                  .empty());
}

TEST(CarveHoles, ABellyPatchBesideOtherDetailsIsNone) {
  EXPECT_TRUE(
      holes_of({arc_stroke({500, 500}, 300, 450, 0, 2 * M_PI),
                arc_stroke({500, 650}, 180, 220, 0, 2 * M_PI), circle_stroke({430, 250}, 30),
                circle_stroke({570, 250}, 30), line_stroke({{450, 330}, {550, 330}}),
                arc_stroke({500, 300}, 150, 100, 0.3, M_PI - 0.3)})
          .empty());
}

TEST(CarveHoles, ALoopOfThePenIsNone) {
  EXPECT_TRUE(holes_of({circle_stroke({500, 500}, 400), circle_stroke({500, 500}, 40)}).empty());
}

TEST(CarveHoles, AnInsideMarkKeepsItsRegionFilled) {
  SimplifyOptions options;
  options.inside = {{500, 500}};
  EXPECT_TRUE(holes_of(ring(), options).empty());
  options.inside = {{500, 200}};  // in the band: the hole may go
  EXPECT_EQ(holes_of(ring(), options).size(), 1U);
}

TEST(CarveHoles, AnOutsideMarkOpensWhatIsNone) {
  SimplifyOptions options;
  options.outside = {{350, 400}};
  auto const holes = holes_of({circle_stroke({500, 500}, 400), circle_stroke({350, 400}, 60),
                               circle_stroke({650, 400}, 60)},
                              options);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_NEAR(area(holes[0]), M_PI * 60 * 60, 0.05 * M_PI * 60 * 60);
}

TEST(CarveHoles, FillLeavesNoHoleInAnyDrawing) {
  SimplifyOptions fill;
  fill.holes = Holes::Fill;
  EXPECT_TRUE(holes_of(ring(), fill).empty());
  EXPECT_TRUE(holes_of(mug(), fill).empty());
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    auto const cells = cells_of(random_sketch(seed));
    // Inside cells only ever become outside.
    auto const inside = labels_of(cells);
    auto const carved = carve_holes(cells, inside, {});
    ASSERT_EQ(carved.size(), inside.size());
    for (std::size_t t = 0; t < inside.size(); ++t) EXPECT_LE(carved[t], inside[t]);
  }
}

TEST(CarveHoles, EverythingKeptMeansNothingCarved) {
  auto const cells = cells_of(sketch_of(ring()));
  auto const inside = labels_of(cells);
  std::vector<int> all(inside.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
  EXPECT_EQ(carve_holes(cells, inside, all), inside);
  EXPECT_NE(carve_holes(cells, inside, {}), inside);
  EXPECT_TRUE(carve_holes(make_cells({}), {}, {}).empty());
}

TEST(CarveHoles, TwoRingsInOneDrawingEachHaveTheirHole) {
  auto const drawing =
      simplify(sketch_of({circle_stroke({250, 250}, 200), circle_stroke({250, 250}, 100),
                          circle_stroke({750, 750}, 200), circle_stroke({750, 750}, 100)}));
  ASSERT_TRUE(drawing.has_value());
  ASSERT_EQ(drawing->layers.size(), 2U);
  for (auto const& layer : drawing->layers) EXPECT_EQ(layer.outlines.size(), 2U);
}

}  // namespace
}  // namespace inkflate
