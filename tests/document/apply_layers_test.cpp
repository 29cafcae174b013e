// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/refusals.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Discs with ids 1, 2, 3, back to front.
Document three_discs() {
  auto document = empty_document();
  for (int i = 1; i <= 3; ++i) {
    document = with_disc(document, {i * 50.0, 50}, 20, "disc " + std::to_string(i));
  }
  return document;
}

Document locked_disc() {
  return with_changed(three_discs(), LayerId{1}, [](Layer& layer) { layer.is_locked = true; });
}

Layer const& layer_of(Result<Document> const& document, int id) {
  return find_layer(*document, LayerId{id})->layer;
}

TEST(OpenLayer, KeepsStrokesAndOutlines) {
  auto const before = three_discs();
  auto const after = inkflate::apply(before, OpenLayer{LayerId{2}});
  ASSERT_TRUE(after);
  EXPECT_TRUE(layer_of(after, 2).is_open);
  EXPECT_TRUE(find_layer(*after, LayerId{2})->strokes.is_same((*before.layers)[1]->strokes));
  EXPECT_EQ((*after->layers)[0], (*before.layers)[0]) << "other layers are shared";
  EXPECT_EQ(test::refusal(*after, OpenLayer{LayerId{2}}), ErrorCode::NothingThere);
}

TEST(OpenLayer, IsUndoneByCloseLayer) {
  auto const open = inkflate::apply(three_discs(), OpenLayer{LayerId{2}});
  ASSERT_TRUE(open);
  auto const closed = inkflate::apply(*open, CloseLayer{LayerId{2}});
  ASSERT_TRUE(closed);
  EXPECT_EQ(to_project(*closed), to_project(three_discs()));
  EXPECT_EQ(test::refusal(*closed, CloseLayer{LayerId{2}}), ErrorCode::BadInput);
}

TEST(RedrawLayer, TakesTheStrokesAndLeavesTheOutlines) {
  auto document = with_changed(three_discs(), LayerId{2}, [](Layer& layer) {
    layer.outlines.front().sources = {{0, 1, 0, 0, 1}};
  });
  auto const after = inkflate::apply(document, RedrawLayer{LayerId{2}});
  ASSERT_TRUE(after);
  EXPECT_TRUE(layer_of(after, 2).is_open);
  EXPECT_TRUE(find_layer(*after, LayerId{2})->strokes.is_empty());
  EXPECT_TRUE(layer_of(after, 2).strokes.empty());
  EXPECT_EQ(layer_of(after, 2).outlines.front().sources.front().stroke, -1);
  EXPECT_EQ(layer_of(after, 2).outlines.size(), 1U);
  EXPECT_EQ(test::refusal(*after, RedrawLayer{LayerId{2}}), ErrorCode::NothingThere);
}

TEST(CloseLayer, RefusesALayerWithoutOutlines) {
  auto const open = with_open(empty_document(), {circle_stroke({0, 0}, 5)});
  EXPECT_EQ(test::refusal(open, CloseLayer{LayerId{1}}), ErrorCode::NothingThere);
}

TEST(DeleteLayers, TakesTheirPinsAndTracks) {
  auto document = three_discs();
  std::vector<Command> const commands = {
      AddPin{{{}, LayerId{2}, Side::Front, {}, {}}}, AddPin{{{}, LayerId{3}, Side::Front, {}, {}}},
      SetTrack{{PinId{4}, {{0, {}}}, 0}}, SetTrack{{PinId{5}, {{0, {}}}, 0}}};
  auto const moved = inkflate::apply(document, std::span<Command const>(commands));
  ASSERT_TRUE(moved);
  auto const after = inkflate::apply(*moved, DeleteLayers{{LayerId{2}, LayerId{1}}});
  ASSERT_TRUE(after);
  EXPECT_EQ(layer_order(*after), std::vector<LayerId>{LayerId{3}});
  ASSERT_EQ(after->pins->size(), 1U);
  EXPECT_EQ(after->pins->front().id, PinId{5});
  ASSERT_EQ(after->clip->tracks.size(), 1U);
  EXPECT_EQ(after->clip->tracks.front().pin, PinId{5});
  EXPECT_EQ(after->next_id, moved->next_id) << "ids are never given again";
}

TEST(DeleteLayers, RefusesNoneUnknownTwiceLocked) {
  EXPECT_EQ(test::refusal(three_discs(), DeleteLayers{}), ErrorCode::NothingThere);
  EXPECT_EQ(test::refusal(three_discs(), DeleteLayers{{LayerId{7}}}), ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(three_discs(), DeleteLayers{{LayerId{1}, LayerId{1}}}),
            ErrorCode::BadInput);
  EXPECT_EQ(test::refusal(locked_disc(), DeleteLayers{{LayerId{2}, LayerId{1}}}),
            ErrorCode::BadInput);
}

TEST(SetLayerOrder, IsTheOrderThatItNames) {
  std::vector<LayerId> const order = {LayerId{3}, LayerId{1}, LayerId{2}};
  auto const after = inkflate::apply(three_discs(), SetLayerOrder{order});
  ASSERT_TRUE(after);
  EXPECT_EQ(layer_order(*after), order);
}

TEST(SetLayerOrder, RefusesWhatIsNoNewOrder) {
  auto const refused = [](std::vector<LayerId> order) {
    return test::refusal(three_discs(), SetLayerOrder{std::move(order)});
  };
  EXPECT_EQ(refused({LayerId{1}, LayerId{2}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({LayerId{1}, LayerId{2}, LayerId{2}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({LayerId{1}, LayerId{2}, LayerId{4}}), ErrorCode::BadInput);
  EXPECT_EQ(refused({LayerId{1}, LayerId{2}, LayerId{3}}), ErrorCode::NothingThere);
}

TEST(SetOfALayer, ChangesOneMember) {
  Command const commands[] = {RenameLayer{LayerId{1}, "\xc4\x8d\xe2\x82\xac\xf0\x9f\x90\x99"},
                              SetThickness{LayerId{1}, 32},
                              SetFill{LayerId{1}, Colour{9, 8, 7}},
                              SetHidden{LayerId{1}, true},
                              SetLocked{LayerId{1}, true},
                              SetChoice{LayerId{1}, {3, {{1, 2}}, {}}}};
  for (auto const& command : commands) {
    auto const after = inkflate::apply(three_discs(), command);
    ASSERT_TRUE(after);
    EXPECT_NE(layer_of(after, 1), (*three_discs().layers)[0]->layer);
    EXPECT_EQ(test::refusal(*after, command), ErrorCode::NothingThere);
  }
}

TEST(SetOfALayer, RefusesValuesOutOfRange) {
  auto const refused = [](Command const& c) { return test::refusal(three_discs(), c); };
  EXPECT_EQ(refused(RenameLayer{LayerId{1}, std::string(201, 'a')}), ErrorCode::BadOption);
  for (double const thickness : {0.0, 33.0, kNan}) {
    EXPECT_EQ(refused(SetThickness{LayerId{1}, thickness}), ErrorCode::BadOption);
  }
  for (double const gap_px : {0.0, -1.0, kNan, 1e300}) {
    EXPECT_EQ(refused(SetChoice{LayerId{1}, {gap_px, {}, {}}}), ErrorCode::BadOption);
  }
  EXPECT_EQ(refused(SetChoice{{}, {{}, {{kNan, 0}}, {}}}), ErrorCode::BadInput);
  EXPECT_EQ(refused(SetChoice{{}, {{}, {}, std::vector<Vec2>(1025)}}), ErrorCode::TooLarge);
  EXPECT_EQ(refused(SetChoice{}), ErrorCode::NothingThere);
  EXPECT_EQ(refused(SetHidden{LayerId{9}, true}), ErrorCode::BadInput);
}

TEST(RenameLayer, RefusesWhatIsNoUtf8) {
  for (auto const* name : {"\xff", "\x80", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80",
                           "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xc3("}) {
    EXPECT_EQ(test::refusal(three_discs(), RenameLayer{LayerId{1}, name}), ErrorCode::BadOption);
  }
}

TEST(LockedLayer, RefusesToBeChangedByName) {
  Command const refused[] = {OpenLayer{LayerId{1}},
                             RedrawLayer{LayerId{1}},
                             CloseLayer{LayerId{1}},
                             DeleteLayers{{LayerId{1}}},
                             TransformLayers{{LayerId{1}}, Affine::translation({1, 1})},
                             SetThickness{LayerId{1}, 5},
                             SetFill{LayerId{1}, Colour{}},
                             SetChoice{LayerId{1}, {3, {}, {}}}};
  for (auto const& command : refused) {
    auto const result = inkflate::apply(locked_disc(), command);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::BadInput);
    EXPECT_NE(result.error().message.find("\"disc 1\" is locked"), std::string::npos);
    EXPECT_EQ(result.error().index, 1);
  }
}

TEST(LockedLayer, MayBeNamedHiddenMovedInOrderCopiedAndUnlocked) {
  Command const allowed[] = {RenameLayer{LayerId{1}, "new"}, SetHidden{LayerId{1}, true},
                             SetLocked{LayerId{1}, false},
                             SetLayerOrder{{LayerId{2}, LayerId{1}, LayerId{3}}},
                             DuplicateLayer{LayerId{1}, OrderEnd::Front, {}}};
  for (auto const& command : allowed) EXPECT_TRUE(inkflate::apply(locked_disc(), command));
}

}  // namespace
}  // namespace inkflate
