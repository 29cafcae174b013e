// SPDX-License-Identifier: Apache-2.0
#include "editor/layer_commands.h"

#include <gtest/gtest.h>

#include <limits>

#include "document/apply.h"
#include "editor/pick.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

constexpr LayerId kBack{1};
constexpr LayerId kFront{2};
constexpr LayerId kNone{99};

using Ids = std::vector<LayerId>;

Document two_discs() {
  return with_disc(with_disc(empty_document(), {300, 300}, 100), {700, 300}, 50);
}

Document after(Document const& document, Result<Command> const& command) {
  EXPECT_TRUE(command.has_value());
  auto const next = inkflate::apply(document, *command);
  EXPECT_TRUE(next.has_value());
  return *next;
}

Document after(Document const& document, Result<std::vector<Command>> const& commands) {
  EXPECT_TRUE(commands.has_value());
  auto const next = inkflate::apply(document, *commands);
  EXPECT_TRUE(next.has_value());
  return *next;
}

template <typename T>
void expect_nothing(Result<T> const& result) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NothingThere);
}

TEST(LayerCommands, NothingSelectedIsRefused) {
  auto const document = two_discs();
  for (auto const& selection : {Ids{}, Ids{kNone}}) {
    expect_nothing(duplicate(document, selection));
    expect_nothing(flip(document, selection, FlipAxis::Horizontal));
    expect_nothing(nudge(document, selection, {1, 0}));
    expect_nothing(step_depth(document, selection, DepthStep::Nearer));
    expect_nothing(step_depth(document, selection, DepthStep::ToBack));
  }
  expect_nothing(duplicate_or_remove(document, kNone, OrderEnd::Back));
  expect_nothing(move_to_index(document, kNone, 0));
}

TEST(LayerCommands, DuplicatesLieAsideBeforeAllOthersInTheirOrder) {
  auto const document = after(two_discs(), duplicate(two_discs(), {kBack, kFront}));
  EXPECT_EQ(layer_order(document), (Ids{kBack, kFront, LayerId{3}, LayerId{4}}));
  auto const box = layer_box(*find_layer(document, LayerId{3}));
  EXPECT_NEAR(distance(box.centre(), {320, 320}), 0, 1e-9);
}

TEST(LayerCommands, DuplicatedTwiceToAnEndIsAsBefore) {
  auto const document = two_discs();
  for (auto const end : {OrderEnd::Back, OrderEnd::Front}) {
    auto const once = after(document, duplicate_or_remove(document, kBack, end));
    EXPECT_EQ(once.layers->size(), 3u);
    EXPECT_EQ(layer_order(once)[end == OrderEnd::Back ? 0 : 2], LayerId{3});
    auto const twice = after(once, duplicate_or_remove(once, kBack, end));
    EXPECT_EQ(layer_order(twice), layer_order(document));
  }
}

TEST(LayerCommands, ACopyIsFoundThoughOthersLieBetween) {
  auto document = two_discs();
  document = after(document, duplicate_or_remove(document, kFront, OrderEnd::Back));
  document = after(document, duplicate_or_remove(document, kBack, OrderEnd::Back));
  EXPECT_EQ(layer_order(document), (Ids{LayerId{4}, LayerId{3}, kBack, kFront}));
  document = after(document, duplicate_or_remove(document, kFront, OrderEnd::Back));
  EXPECT_EQ(layer_order(document), (Ids{LayerId{4}, kBack, kFront}));
}

TEST(LayerCommands, ACopyThatWasChangedIsNoCopyAnyMore) {
  auto document = two_discs();
  document = after(document, duplicate_or_remove(document, kFront, OrderEnd::Back));
  document = after(document, nudge(document, {LayerId{3}}, {0, 1}));
  document = after(document, duplicate_or_remove(document, kFront, OrderEnd::Back));
  EXPECT_EQ(document.layers->size(), 4u);
}

TEST(LayerCommands, ALockedCopyIsLeft) {
  auto document = two_discs();
  document = after(document, duplicate_or_remove(document, kFront, OrderEnd::Back));
  document = with_changed(document, LayerId{3}, [](Layer& layer) { layer.is_locked = true; });
  document = after(document, duplicate_or_remove(document, kFront, OrderEnd::Back));
  EXPECT_EQ(document.layers->size(), 4u);
}

TEST(LayerCommands, OpenLayersAreCopiesByTheirStrokes) {
  auto document = with_open(empty_document(), {line_stroke({{0, 0}, {9, 9}})});
  document = with_open(document, {line_stroke({{0, 0}, {9, 8}})});
  document = after(document, duplicate_or_remove(document, kFront, OrderEnd::Back));
  EXPECT_EQ(document.layers->size(), 3u);
  document = with_open(document, {});
  document = after(document, duplicate_or_remove(document, LayerId{4}, OrderEnd::Back));
  EXPECT_EQ(document.layers->size(), 5u);
}

TEST(LayerCommands, FlippedTwiceLiesWhereItWas) {
  auto const document = two_discs();
  auto const box = box_of(document, {kBack, kFront});
  for (auto const axis : {FlipAxis::Horizontal, FlipAxis::Vertical}) {
    auto const once = after(document, flip(document, {kBack, kFront}, axis));
    auto const flipped = layer_box(*find_layer(once, kFront)).centre();
    Vec2 const mirrored = axis == FlipAxis::Horizontal ? Vec2{250, 300} : Vec2{700, 300};
    EXPECT_NEAR(distance(flipped, mirrored), 0, 1e-9);
    auto const twice = after(once, flip(once, {kBack, kFront}, axis));
    EXPECT_NEAR(distance(box_of(twice, {kBack, kFront}).min, box.min), 0, 1e-9);
  }
}

TEST(LayerCommands, FlipsOfNothingAreRefused) {
  auto const document = with_open(empty_document(), {});
  expect_nothing(flip(document, {kBack}, FlipAxis::Vertical));
}

TEST(LayerCommands, NudgeMovesWhatIsNotLocked) {
  auto const document =
      with_changed(two_discs(), kFront, [](Layer& layer) { layer.is_locked = true; });
  auto const next = after(document, nudge(document, {kBack, kFront}, {-1, 10}));
  EXPECT_NEAR(distance(layer_box(*find_layer(next, kBack)).centre(), {299, 310}), 0, 1e-9);
  EXPECT_NEAR(distance(layer_box(*find_layer(next, kFront)).centre(), {700, 300}), 0, 1e-9);
  expect_nothing(nudge(document, {kFront}, {1, 0}));
}

TEST(LayerCommands, ANudgeByNothingOrByNoNumberIsRefused) {
  expect_nothing(nudge(two_discs(), {kBack}, {0, 0}));
  auto const far = nudge(two_discs(), {kBack}, {std::numeric_limits<double>::infinity(), 0});
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ErrorCode::BadInput);
}

}  // namespace
}  // namespace inkflate
