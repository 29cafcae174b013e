// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "document/apply.h"
#include "editor/layer_commands.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

using Ids = std::vector<LayerId>;

/// Ids by their numbers, back to front.
Ids ids(std::vector<int> const& numbers) {
  Ids result;
  for (int const number : numbers) result.push_back(LayerId{number});
  return result;
}

/// Discs of radius 100 along a line, back to front.
Document discs_at(std::vector<double> const& centres) {
  auto document = empty_document();
  for (double const x : centres) document = with_disc(document, {x, 500}, 100);
  return document;
}

/// The order after a step; the old one where it is refused.
Ids stepped(Document const& document, std::vector<int> const& selection, DepthStep step) {
  auto const command = step_depth(document, ids(selection), step);
  if (!command) {
    EXPECT_EQ(command.error().code, ErrorCode::NothingThere);
    return layer_order(document);
  }
  auto const next = inkflate::apply(document, *command);
  EXPECT_TRUE(next.has_value());
  return layer_order(*next);
}

TEST(StepDepth, CountsOnlyStepsPastLayersThatOverlap) {
  auto const document = discs_at({500, 900, 550, 520});
  EXPECT_EQ(stepped(document, {1}, DepthStep::Nearer), ids({2, 3, 1, 4}));
  EXPECT_EQ(stepped(document, {4}, DepthStep::Farther), ids({1, 2, 4, 3}));
}

TEST(StepDepth, FartherTakesNearerBack) {
  auto const document = discs_at({500, 550, 600});
  auto const order = stepped(document, {1}, DepthStep::Nearer);
  EXPECT_EQ(order, ids({2, 1, 3}));
  auto const next = inkflate::apply(document, *step_depth(document, ids({1}), DepthStep::Nearer));
  EXPECT_EQ(stepped(*next, {1}, DepthStep::Farther), ids({1, 2, 3}));
}

TEST(StepDepth, WithoutAnythingToPassItIsRefused) {
  auto const document = discs_at({100, 500, 900});
  EXPECT_FALSE(step_depth(document, ids({1}), DepthStep::Nearer));
  EXPECT_FALSE(step_depth(document, ids({3}), DepthStep::Farther));
  EXPECT_FALSE(step_depth(discs_at({500, 500}), ids({2}), DepthStep::Nearer));
}

TEST(StepDepth, TheSelectedKeepTheirOrder) {
  auto const document = discs_at({500, 520, 540, 560});
  EXPECT_EQ(stepped(document, {1, 2}, DepthStep::Nearer), ids({3, 1, 2, 4}));
  EXPECT_EQ(stepped(document, {1, 3}, DepthStep::Nearer), ids({2, 1, 4, 3}));
  EXPECT_EQ(stepped(document, {3, 4}, DepthStep::Farther), ids({1, 3, 4, 2}));
  EXPECT_EQ(stepped(document, {3, 4}, DepthStep::Nearer), ids({1, 2, 3, 4}));
}

TEST(StepDepth, OneThatWouldPassAnotherSelectedTakesItAlong) {
  // The second lies alone; the first overlaps the third.
  auto const document = discs_at({300, 800, 350});
  EXPECT_EQ(stepped(document, {1, 2}, DepthStep::Nearer), ids({3, 1, 2}));
}

TEST(StepDepth, ToAnEndGoesPastAll) {
  auto const document = discs_at({100, 500, 900, 300});
  EXPECT_EQ(stepped(document, {1, 3}, DepthStep::ToFront), ids({2, 4, 1, 3}));
  EXPECT_EQ(stepped(document, {2, 4}, DepthStep::ToBack), ids({2, 4, 1, 3}));
  EXPECT_FALSE(step_depth(document, ids({1}), DepthStep::ToBack));
}

TEST(StepDepth, LayersInsideOfOthersOverlapThem) {
  auto const document = with_disc(with_disc(empty_document(), {500, 500}, 200), {520, 500}, 20);
  EXPECT_EQ(stepped(document, {1}, DepthStep::Nearer), ids({2, 1}));
  EXPECT_EQ(stepped(document, {2}, DepthStep::Farther), ids({2, 1}));
}

TEST(StepDepth, ALayerInAHoleOverlapsNothing) {
  auto const document =
      with_disc(with_ring(empty_document(), {500, 500}, 200, 100), {500, 500}, 50);
  EXPECT_FALSE(step_depth(document, ids({1}), DepthStep::Nearer));
}

TEST(StepDepth, BoxesThatTouchAreNoOverlapYet) {
  auto const document = with_disc(with_disc(empty_document(), {300, 300}, 100), {450, 450}, 100);
  EXPECT_FALSE(step_depth(document, ids({1}), DepthStep::Nearer));
}

TEST(StepDepth, LayersWithoutOutlinesOverlapByTheirBoxes) {
  auto document = with_disc(empty_document(), {300, 300}, 100);
  document = with_open(document, {line_stroke({{350, 350}, {600, 600}})});
  document = with_open(document, {});
  EXPECT_EQ(stepped(document, {1}, DepthStep::Nearer), ids({2, 1, 3}));
  EXPECT_FALSE(step_depth(document, ids({2}), DepthStep::Nearer));
}

TEST(MoveToIndex, PutsALayerAtItsPlaceFromTheBack) {
  auto const document = discs_at({100, 300, 500});
  auto const order = [&](int layer, int index) {
    auto const command = move_to_index(document, LayerId{layer}, index);
    EXPECT_TRUE(command.has_value());
    return layer_order(*inkflate::apply(document, *command));
  };
  EXPECT_EQ(order(1, 1), ids({2, 1, 3}));
  EXPECT_EQ(order(1, 2), ids({2, 3, 1}));
  EXPECT_EQ(order(1, 1000), ids({2, 3, 1}));
  EXPECT_EQ(order(3, -7), ids({3, 1, 2}));
}

TEST(MoveToIndex, ToTheSamePlaceIsRefused) {
  auto const result = move_to_index(discs_at({100, 300}), LayerId{2}, 1);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NothingThere);
}

TEST(MoveToIndex, ALayerThatThereIsNotIsRefused) {
  auto const result = move_to_index(discs_at({100}), LayerId{7}, 0);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NothingThere);
}

}  // namespace
}  // namespace inkflate
