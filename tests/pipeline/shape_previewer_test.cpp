// SPDX-License-Identifier: Apache-2.0
#include "pipeline/shape_previewer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "document/apply.h"
#include "support/closed_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Stroke far(Stroke stroke) {
  stroke.depth = StrokeDepth::Far;
  return stroke;
}

double area(ShapePreview const& preview) {
  double sum = 0;
  for (auto const& contour : preview.contours) sum += signed_area(contour);
  return sum;
}

/// How many stages a preview enters.
int stages_of(ShapePreviewer& previewer, Document const& document) {
  int stages = 0;
  (void)previewer.preview(document, {[&](auto) { ++stages; }, {}});
  return stages;
}

TEST(PreviewShape, OfNothingIsEmpty) {
  EXPECT_EQ(preview_shape(empty_document()), ShapePreview{});
  EXPECT_EQ(preview_shape(drawn({line_stroke({{1, 1}, {500, 500}})})), ShapePreview{});
}

TEST(PreviewShape, IsWhatCloseDocumentMakes) {
  auto const document = drawn(
      {arc_stroke({300, 500}, 200, 200, 0, 6.0), far(arc_stroke({700, 500}, 150, 150, 1, 7.0))});
  auto const closed = close_document(document);
  ASSERT_TRUE(closed.has_value());
  ASSERT_TRUE(closed->command.has_value());
  auto const preview = preview_shape(document);
  EXPECT_EQ(std::ssize(preview.closings), closed->closings);
  double sum = 0;
  for (auto const& set : closed->command->sets) {
    for (auto const& outline : set.shapes.front().outlines)
      sum += signed_area(flatten(outline, 0.1));
  }
  EXPECT_NEAR(area(preview), sum, 0.01 * sum);
}

TEST(PreviewShape, EachSetIsAnAreaOfItsOwn) {
  auto const preview =
      preview_shape(drawn({circle_stroke({500, 500}, 200), far(circle_stroke({500, 500}, 200))}));
  EXPECT_EQ(preview.areas, (std::vector<int>{0, 1}));
  EXPECT_EQ(preview.contours.size(), 2);
}

TEST(PreviewShape, ShowsOpenLayersButNotClosedOnes) {
  auto document = drawn({circle_stroke({500, 500}, 200)});
  auto const closed = close_document(document);
  ASSERT_TRUE(closed && closed->command);
  document = *apply(document, *closed->command);
  EXPECT_EQ(preview_shape(document), ShapePreview{});
  document = *apply(document, OpenLayer{document.layers->front()->layer.id});
  EXPECT_EQ(preview_shape(document).contours.size(), 1);
}

TEST(PreviewShape, CancelledIsEmpty) {
  auto const document = drawn({circle_stroke({500, 500}, 200)});
  EXPECT_EQ(preview_shape(document, {{}, [] { return true; }}), ShapePreview{});
}

TEST(PreviewShape, OfHostileStrokesIsFinite) {
  for (auto const& strokes : std::vector<std::vector<Stroke>>{
           {circle_stroke({1e6 - 1, 1e6 - 1}, 1e-3), line_stroke({{-1e6, 1e6}})},
           {circle_stroke({0, 0}, 1e-300)},
           {circle_stroke({0, 0}, 1e6), far(circle_stroke({0, 0}, 1e-3))}}) {
    for (auto const& contour : preview_shape(drawn(strokes)).contours) {
      for (auto const p : contour) EXPECT_TRUE(is_finite(p));
    }
  }
}

TEST(ShapePreviewer, WorksOnlyOnWhatHasChanged) {
  ShapePreviewer previewer;
  auto document = drawn({circle_stroke({300, 500}, 100), far(circle_stroke({700, 500}, 100))});
  int const both = stages_of(previewer, document);
  EXPECT_GT(both, 0);
  EXPECT_EQ(stages_of(previewer, document), 0);
  document = drawn(document, {circle_stroke({300, 500}, 50)});
  EXPECT_EQ(stages_of(previewer, document), both / 2);
  EXPECT_EQ(previewer.preview(document), preview_shape(document));
}

TEST(ShapePreviewer, SeesAnotherChoice) {
  ShapePreviewer previewer;
  auto const document = drawn({arc_stroke({300, 500}, 200, 200, 0, 5.9)});
  EXPECT_EQ(previewer.preview(document).closings.size(), 1);
  auto const other = apply(document, SetChoice{LayerId::None, {3, {}, {}}});
  ASSERT_TRUE(other.has_value());
  EXPECT_EQ(previewer.preview(*other), ShapePreview{});
}

TEST(ShapePreviewer, CancelledKnowsWhatItKnew) {
  ShapePreviewer previewer;
  auto const document = drawn({circle_stroke({300, 500}, 100)});
  (void)previewer.preview(document);
  auto const next = drawn(document, {circle_stroke({300, 500}, 50)});
  EXPECT_EQ(previewer.preview(next, {{}, [] { return true; }}), ShapePreview{});
  EXPECT_EQ(stages_of(previewer, document), 0);
}

}  // namespace
}  // namespace inkflate
