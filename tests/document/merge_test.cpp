// SPDX-License-Identifier: Apache-2.0
#include "document/merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "support/editor_documents.h"
#include "support/random_document.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Document with_groups(Document document, std::vector<StrokeGroup> groups) {
  document.groups = std::make_shared<std::vector<StrokeGroup> const>(std::move(groups));
  return document;
}

Stroke grouped(int group) {
  auto stroke = line_stroke({{0, 0}, {9, 9}});
  stroke.group = group;
  return stroke;
}

Shared<Picture> picture(int side) { return std::make_shared<Picture const>(side, side); }

TEST(Merge, UpperLayersLieBeforeLowerOnesWithNewIds) {
  auto const lower = with_disc(with_disc(empty_document(), {10, 10}, 5, "a"), {20, 20}, 5, "b");
  auto const upper = with_disc(empty_document(), {30, 30}, 5, "c");
  auto const both = merged(lower, upper);
  ASSERT_EQ(both.layers->size(), 3U);
  EXPECT_EQ((*both.layers)[0], (*lower.layers)[0]) << "shared";
  EXPECT_EQ((*both.layers)[2]->layer.name, "c");
  EXPECT_EQ(layer_order(both), (std::vector<LayerId>{LayerId{1}, LayerId{2}, LayerId{3}}));
  EXPECT_EQ(both.next_id, 4);
}

TEST(Merge, LooseStrokesOfBothAreKeptInOrder) {
  auto const lower = with_loose(empty_document(), line_stroke({{1, 1}, {2, 2}}));
  auto const upper = with_loose(empty_document(), line_stroke({{3, 3}, {4, 4}}));
  auto const both = merged(lower, upper);
  ASSERT_EQ(both.loose.size(), 2);
  EXPECT_EQ(both.loose[0], lower.loose[0]);
  EXPECT_EQ(both.loose[1], upper.loose[0]);
}

TEST(Merge, StrokesKeepTheirGroups) {
  auto const lower = with_groups(empty_document(), {{"l0"}, {"l1"}});
  auto upper = with_loose(with_groups(empty_document(), {{"u0"}}), grouped(0));
  upper = with_layer(with_loose(upper, grouped(-1)), {}, {grouped(0)});
  auto const both = merged(lower, upper);
  ASSERT_EQ(both.groups->size(), 3U);
  EXPECT_EQ((*both.groups)[2].name, "u0");
  EXPECT_EQ(both.loose[0]->stroke.group, 2);
  EXPECT_EQ(both.loose[1]->stroke.group, -1);
  EXPECT_EQ((*both.layers)[0]->strokes[0]->stroke.group, 2);
}

TEST(Merge, PinsComeAlongOnTheirLayersWithoutTracks) {
  auto const lower = with_disc(empty_document(), {10, 10}, 5);
  auto upper = with_disc(empty_document(), {30, 30}, 5);
  Pin const pin = {PinId{2}, LayerId{1}, Side::Front, {30, 30}, {31, 31}};
  upper.pins = std::make_shared<std::vector<Pin> const>(1, pin);
  upper.clip = std::make_shared<Clip const>(Clip{2, {{PinId{2}, {{1, {5, 5}}}, 0}}});
  upper.next_id = 3;
  auto const both = merged(lower, upper);
  ASSERT_EQ(both.pins->size(), 1U);
  EXPECT_EQ(both.pins->front().layer, both.layers->back()->layer.id);
  EXPECT_EQ(both.pins->front().position, pin.position);
  EXPECT_LT(static_cast<int>(both.pins->front().id), both.next_id);
  EXPECT_EQ(both.clip, lower.clip);
}

TEST(Merge, TheTemplateIsTheLowerOneWhereThereIsOne) {
  auto lower = empty_document();
  auto upper = empty_document();
  upper.template_picture = picture(2);
  EXPECT_EQ(merged(lower, upper).template_picture, upper.template_picture);
  lower.template_picture = picture(1);
  EXPECT_EQ(merged(lower, upper).template_picture, lower.template_picture);
}

TEST(Merge, CanvasAndChoiceAreThoseOfTheLower) {
  auto lower = empty_document();
  lower.width_px = 321;
  lower.choice = std::make_shared<CloseChoice const>(CloseChoice{7.0});
  auto const both = merged(lower, empty_document());
  EXPECT_EQ(both.width_px, 321);
  EXPECT_EQ(both.choice, lower.choice);
}

TEST(Merge, WhateverIsMergedIsADocumentThatAFileCanHold) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng(seed);
    auto const lower = test::random_document(rng);
    auto const upper = test::random_document(rng);
    auto const both = to_project(merged(lower, upper));
    auto const again = make_document(both);
    ASSERT_TRUE(again) << seed << ": " << again.error().message;
    EXPECT_EQ(to_project(*again), both) << seed;
  }
}

}  // namespace
}  // namespace inkflate
