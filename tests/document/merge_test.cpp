// SPDX-License-Identifier: Apache-2.0
#include "document/merge.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/random_document.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Document with_group(Document document, std::string name) {
  auto groups = *document.groups;
  groups.push_back({std::move(name)});
  document.groups = std::make_shared<std::vector<StrokeGroup> const>(std::move(groups));
  return document;
}

Stroke in_group(int group) {
  auto stroke = line_stroke({{0, 0}, {9, 9}});
  stroke.group = group;
  return stroke;
}

Document with_template(Document document, int side_px) {
  document.template_picture = std::make_shared<Picture const>(side_px, side_px);
  return document;
}

Document pinned_disc() {
  return *inkflate::apply(with_disc(empty_document(), {50, 50}, 20),
                          AddPin{{{}, LayerId{1}, Side::Front, {50, 50}, {60, 60}}});
}

TEST(Merged, UpperLayersLieBeforeTheLowerOnesWithIdsOfTheirOwn) {
  auto const lower = with_disc(with_disc(empty_document(), {50, 50}, 20, "a"), {9, 9}, 5, "b");
  auto const both = merged(lower, with_disc(empty_document(), {80, 80}, 30, "c"));
  EXPECT_EQ(layer_order(both), (std::vector<LayerId>{LayerId{1}, LayerId{2}, LayerId{3}}));
  EXPECT_EQ(both.layers->back()->layer.name, "c");
  EXPECT_EQ(both.next_id, 4);
  EXPECT_EQ(both.layers->front(), lower.layers->front()) << "the lower ones are shared";
}

TEST(Merged, PinsFollowTheirLayerToItsNewId) {
  auto const both = merged(pinned_disc(), pinned_disc());
  ASSERT_EQ(both.pins->size(), 2U);
  EXPECT_EQ(both.pins->front(), pinned_disc().pins->front());
  EXPECT_EQ(both.pins->back().layer, both.layers->back()->layer.id);
  EXPECT_EQ(both.pins->back().position, (Vec2{60, 60}));
}

TEST(Merged, StrokesStayInTheirGroups) {
  auto const lower = with_loose(with_group(empty_document(), "arm"), in_group(0));
  auto upper = with_group(with_group(empty_document(), "leg"), "tail");
  upper = with_open(with_loose(with_loose(upper, in_group(1)), in_group(-1)), {in_group(0)});
  auto const both = merged(lower, upper);
  auto const group_of = [&](Shared<KeptStroke> const& kept) {
    int const group = kept->stroke.group;
    return group < 0 ? std::string() : both.groups->at(static_cast<std::size_t>(group)).name;
  };
  ASSERT_EQ(both.loose.size(), 3);
  EXPECT_EQ(group_of(both.loose[0]), "arm");
  EXPECT_EQ(group_of(both.loose[1]), "tail");
  EXPECT_EQ(group_of(both.loose[2]), "");
  EXPECT_EQ(group_of(both.layers->back()->strokes[0]), "leg");
}

TEST(Merged, TheLowerTemplateStaysUnlessThereIsNone) {
  auto const small = with_template(empty_document(), 3);
  auto const large = with_template(empty_document(), 7);
  EXPECT_EQ(merged(small, large).template_picture, small.template_picture);
  EXPECT_EQ(merged(empty_document(), large).template_picture, large.template_picture);
}

TEST(Merged, NothingPutBeforeADocumentLeavesIt) {
  Rng rng(5);
  for (int i = 0; i < 50; ++i) {
    auto const document = test::random_document(rng);
    EXPECT_EQ(to_project(merged(document, empty_document())), to_project(document));
  }
}

TEST(Merged, AnyTwoDocumentsGiveAWholeOne) {
  Rng rng(6);
  for (int i = 0; i < 100; ++i) {
    auto const lower = test::random_document(rng);
    auto const upper = test::random_document(rng);
    auto const both = merged(lower, upper);
    auto const again = make_document(to_project(both));
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(to_project(*again), to_project(both));
    EXPECT_EQ(both.layers->size(), lower.layers->size() + upper.layers->size());
    EXPECT_EQ(both.pins->size(), lower.pins->size() + upper.pins->size());
    EXPECT_EQ(both.loose.size(), lower.loose.size() + upper.loose.size());
    EXPECT_EQ(*both.clip, *lower.clip);
  }
}

}  // namespace
}  // namespace inkflate
