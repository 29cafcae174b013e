// SPDX-License-Identifier: Apache-2.0
#include "document/history.h"

#include <gtest/gtest.h>

#include "document/apply.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Command stroke_at(double x) { return AddStroke{line_stroke({{x, 0}, {x, 9}}), LayerId::None}; }

TEST(History, NewOneHasNothingToUndoOrRedo) {
  History history(empty_document());
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.undo_label(), -1);
  EXPECT_EQ(history.redo_label(), -1);
  EXPECT_EQ(history.size(), 0);
}

TEST(History, UndoGivesBackTheVeryDocumentOfBefore) {
  History history(empty_document());
  ASSERT_TRUE(history.push({stroke_at(1)}, 7));
  auto const one = history.document();
  ASSERT_TRUE(history.push({stroke_at(2), stroke_at(3)}, 8));
  EXPECT_EQ(history.document().loose.size(), 3);
  EXPECT_EQ(history.undo_label(), 8);
  EXPECT_TRUE(history.undo());
  EXPECT_TRUE(history.document().loose.is_same(one.loose));
  EXPECT_EQ(history.undo_label(), 7);
  EXPECT_EQ(history.redo_label(), 8);
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(history.document().loose.size(), 3);
  EXPECT_EQ(history.position(), 2);
}

TEST(History, WhatWasUndoneIsGoneAfterANewStep) {
  History history(empty_document());
  ASSERT_TRUE(history.push({stroke_at(1)}, 1));
  ASSERT_TRUE(history.push({stroke_at(2)}, 2));
  history.undo();
  history.undo();
  history.push(with_disc(empty_document(), {5, 5}, 2), 3);
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.size(), 1);
  EXPECT_EQ(history.undo_label(), 3);
}

TEST(History, RefusedStepChangesNothing) {
  History history(empty_document());
  ASSERT_TRUE(history.push({stroke_at(1)}, 1));
  history.undo();
  auto const refused = history.push({stroke_at(2), OpenLayer{LayerId{9}}}, 2);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::BadInput);
  EXPECT_TRUE(history.can_redo());
  EXPECT_TRUE(history.document().loose.is_empty());
}

TEST(History, StepOfNoCommandsIsRefused) {
  History history(empty_document());
  auto const refused = history.push(std::vector<Command>{}, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::NothingThere);
}

TEST(Apply, RefusedCommandAmongOthersRefusesAll) {
  std::vector<Command> const commands = {OpenLayer{LayerId{9}}, stroke_at(1)};
  auto const refused = inkflate::apply(empty_document(), std::span<Command const>(commands));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().index, 9);
}

}  // namespace
}  // namespace inkflate
