// SPDX-License-Identifier: Apache-2.0
#include "pipeline/lay_details.h"

#include <gtest/gtest.h>

#include "document/apply.h"
#include "support/closed_documents.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

TEST(LayDetails, WhatEnclosesNothingBecomesADetailOfTheLayerBelow) {
  auto document =
      simplified(drawn({circle_stroke({500, 500}, 200), circle_stroke({150, 150}, 80)}));
  ASSERT_EQ(document.layers->size(), 2);
  auto const back = layer_at(document, 0).id;
  auto const area_before = area(layer_at(document, 0));
  document = drawn(document, {line_stroke({{420, 480}, {330, 470}}),
                              line_stroke({{580, 480}, {720, 470}}),  // its end is outside
                              line_stroke({{800, 800}, {900, 830}}),  // on nothing
                              line_stroke({{150, 130}, {150, 170}})});
  auto const result = closed(document);
  EXPECT_EQ(result.details, 3);
  EXPECT_EQ(result.faults.size(), 1);
  ASSERT_TRUE(result.command.has_value());
  EXPECT_TRUE(result.command->sets.empty());
  auto const after = must(apply(document, *result.command));
  EXPECT_EQ(after.loose.size(), 1);
  EXPECT_EQ(find_layer(after, back)->layer.details.size(), 2);
  EXPECT_EQ(layer_at(after, 1).details.size(), 1);
  EXPECT_EQ(area(layer_at(after, 0)), area_before);
}

TEST(LayDetails, DetailsOfALayerBelowAreNoNoiseOfANewShape) {
  auto document = simplified(drawn({circle_stroke({500, 500}, 200)}));
  document =
      drawn(document, {line_stroke({{500, 480}, {520, 600}}), circle_stroke({850, 500}, 90)});
  auto const result = closed(document);
  EXPECT_EQ(result.details, 1);
  EXPECT_TRUE(result.faults.empty());
  auto const after = must(apply(document, *result.command));
  ASSERT_EQ(after.layers->size(), 2);
  EXPECT_EQ(layer_at(after, 0).details.size(), 1);
  EXPECT_TRUE(layer_at(after, 1).noise.empty());
}

TEST(LayDetails, DetailsGoToTheForemostLayerThatIsFree) {
  auto document = simplified(drawn({circle_stroke({500, 500}, 200)}));
  document = simplified(drawn(document, {circle_stroke({500, 500}, 150)}));
  document = simplified(drawn(document, {circle_stroke({500, 500}, 100)}));
  document = simplified(drawn(document, {circle_stroke({500, 500}, 90)}));
  auto const hidden = layer_at(document, 3).id;
  document = must(apply(document, SetHidden{hidden, true}));
  document = must(apply(document, SetLocked{layer_at(document, 2).id, true}));
  document = drawn(document, {line_stroke({{480, 500}, {520, 500}})});
  auto const command = closed(document).command;
  ASSERT_TRUE(command.has_value());
  ASSERT_EQ(command->details.size(), 1);
  EXPECT_EQ(command->details.front().layer, layer_at(document, 1).id);
}

TEST(LayDetails, HelpLinesAndGuidesAreNoDetails) {
  auto guide = line_stroke({{480, 500}, {520, 500}});
  guide.group = 0;
  Project project;
  project.drawing.sketch = sketch_of({guide});
  project.drawing.sketch.groups = {{"construction"}};
  project.drawing.stray = {0};
  auto document = must(make_document(project));
  document = with_disc(document, {500, 500}, 200);
  document = drawn(document, {line_stroke({{480, 520}, {520, 520}}, StrokeKind::HelpLine)});
  auto const result = closed(document);
  EXPECT_FALSE(result.command.has_value());
  EXPECT_EQ(result.faults.size(), 1);
}

}  // namespace
}  // namespace inkflate
