// SPDX-License-Identifier: Apache-2.0
#include "simplify/sort_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/cells.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

using Strokes = std::vector<int>;

Layer layer_around(Contour const& contour) {
  Layer layer;
  layer.outlines.resize(1);
  for (std::size_t i = 0; i < contour.size(); ++i)
    layer.outlines[0].pieces.push_back(
        {line_cubic(contour[i], contour[(i + 1) % contour.size()]), RunKind::Ink});
  return layer;
}

Layer square(double x, double y, double side) {
  return layer_around({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

/// Sorts the strokes of a sketch in the space of its canvas: two dots see to it.
Strokes sort(std::vector<Stroke> strokes, std::vector<Layer>& layers) {
  int const count = static_cast<int>(std::ssize(strokes));
  strokes.push_back(line_stroke({{0, 0}}));
  strokes.push_back(line_stroke({{1000, 1000}}));
  auto const sketch = sketch_of(std::move(strokes));
  auto stray = sort_strokes(samples_of(sketch), space_of(sketch), layers);
  std::erase_if(stray, [&](int stroke) { return stroke >= count; });
  return stray;
}

TEST(SortStrokes, OutlineDetailWhiskerAndNoise) {
  std::vector<Layer> layers = {square(300, 300, 400)};
  auto const stray = sort({line_stroke({{305, 302}, {695, 298}}),   // along the upper side
                           line_stroke({{400, 500}, {600, 520}}),   // inside
                           line_stroke({{700, 500}, {900, 450}}),   // from the right side outwards
                           line_stroke({{100, 800}, {150, 850}}),   // far from all
                           line_stroke({{500, 500}}),               // a dot inside
                           line_stroke({{500, 250}, {500, 690}})},  // across
                          layers);
  EXPECT_EQ(layers[0].strokes, Strokes{0});
  EXPECT_EQ(layers[0].details, (Strokes{1, 2, 4, 5}));
  EXPECT_EQ(stray, Strokes{3});
}

TEST(SortStrokes, ATurnedHatchDrawsNoOutlineThoughItIsNear) {
  std::vector<Layer> layers = {square(300, 300, 400)};
  std::vector<Stroke> hatching;
  for (int i = 0; i < 20; ++i)
    hatching.push_back(line_stroke({{320 + 15.0 * i, 295}, {322 + 15.0 * i, 307}}));
  sort(hatching, layers);
  EXPECT_TRUE(layers[0].strokes.empty());
  EXPECT_EQ(layers[0].details.size(), 20U);
}

TEST(SortStrokes, HolesAreOutlinesAsWell) {
  std::vector<Layer> layers = {square(300, 300, 400)};
  layers[0].outlines.push_back(
      layer_around({{400, 400}, {400, 600}, {600, 600}, {600, 400}}).outlines[0]);
  sort({line_stroke({{410, 401}, {590, 399}})}, layers);
  EXPECT_EQ(layers[0].strokes, Strokes{0});
}

TEST(SortStrokes, TheLayerWithTheLargestShareGetsTheStroke) {
  std::vector<Layer> layers = {square(100, 100, 300), square(410, 100, 300)};
  auto const stray =
      sort({line_stroke({{400, 110}, {400, 390}}), line_stroke({{411, 110}, {411, 390}}),
            line_stroke({{200, 200}, {300, 210}}), line_stroke({{500, 200}, {600, 210}})},
           layers);
  EXPECT_TRUE(stray.empty());
  EXPECT_EQ(layers[0].strokes, Strokes{0});
  EXPECT_EQ(layers[1].strokes, Strokes{1});
  EXPECT_EQ(layers[0].details, Strokes{2});
  EXPECT_EQ(layers[1].details, Strokes{3});
}

TEST(SortStrokes, DetailsLieOnTheLayerInFront) {
  std::vector<Layer> layers = {square(100, 100, 800), square(300, 300, 400)};
  sort({line_stroke({{450, 450}, {550, 560}}), line_stroke({{150, 180}, {250, 250}})}, layers);
  EXPECT_EQ(layers[1].details, Strokes{0});
  EXPECT_EQ(layers[0].details, Strokes{1});
}

TEST(SortStrokes, WithoutLayersAllIsStray) {
  std::vector<Layer> none;
  EXPECT_EQ(sort({line_stroke({{1, 1}, {9, 9}}), line_stroke({{5, 5}})}, none), (Strokes{0, 1}));
}

TEST(SortStrokes, EveryStrokeIsInOnePlaceInDrawingOrder) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    auto const sketch = random_sketch(seed);
    auto const space = space_of(sketch);
    std::vector<Layer> layers = {square(100, 100, 300), square(390, 200, 500),
                                 square(450, 300, 100)};
    for (auto& layer : layers) {
      for (auto& piece : layer.outlines[0].pieces) {
        for (auto& control : piece.curve.control) control = space.canvas_point(control);
      }
    }
    auto const stray = sort_strokes(samples_of(sketch), space, layers);
    std::vector<Strokes const*> lists = {&stray};
    for (auto const& layer : layers) {
      lists.push_back(&layer.strokes);
      lists.push_back(&layer.details);
    }
    std::set<int> seen;
    for (auto const* list : lists) {
      EXPECT_TRUE(std::is_sorted(list->begin(), list->end()));
      for (int const stroke : *list) EXPECT_TRUE(seen.insert(stroke).second);
    }
    for (int i = 0; i < std::ssize(sketch.strokes); ++i)
      EXPECT_EQ(seen.count(i), sketch.strokes[i].samples.empty() ? 0U : 1U) << seed;
  }
}

}  // namespace
}  // namespace inkflate
