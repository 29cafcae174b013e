// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "io/put_bytes.h"
#include "support/artist.h"
#include "web/bindings/changes_answer.h"
#include "web/bindings/scene_answer.h"
#include "web/bindings/state_answer.h"
#include "web/bindings/work_share.h"

namespace inkflate::web {
namespace {

Json head_of(Answer const& answer) { return Json::parse(answer.head); }

/// A blob of an answer by its place in the head.
std::string blob(Answer const& answer, Json const& place) {
  std::string text;
  auto const start = place.at(0).get<std::size_t>();
  for (auto i = start; i < start + place.at(1).get<std::size_t>(); ++i) {
    text.push_back(static_cast<char>(answer.blobs.at(i)));
  }
  return text;
}

TEST(BlobWriter, BlobsBeginAtMultiplesOfFour) {
  BlobWriter blobs;
  auto const first = blobs.add(bytes_of("abcde"));
  auto const second = blobs.add(bytes_of("f"));
  EXPECT_EQ(second, Json::array({8, 1}));
  auto const answer = blobs.answer({});
  EXPECT_EQ(blob(answer, first), "abcde");
  EXPECT_EQ(blob(answer, second), "f");
}

TEST(ChangesAnswer, GatheredChangesAreAllThere) {
  Changes changes;
  Changes next;
  next.is_scene_changed = true;
  next.files.push_back({"a.svg", bytes_of("<svg/>")});
  next.journal = "one ";
  gather(changes, next);
  next = {};
  next.is_state_changed = true;
  next.studio_actions = {"help"};
  next.messages.push_back({Severity::Warning, Word::NothingSelected, {}, Rect{{1, 2}, {4, 6}}});
  next.journal = "two";
  gather(changes, next);
  auto const answer = changes_answer(changes, Recovery::Whole, Language::English);
  auto const head = head_of(answer);
  EXPECT_TRUE(head.at("isSceneChanged"));
  EXPECT_TRUE(head.at("isStateChanged"));
  EXPECT_FALSE(head.at("isDocumentChanged"));
  EXPECT_EQ(head.at("requests"), Json::array({"help"}));
  EXPECT_EQ(head.at("files").at(0).at("name"), "a.svg");
  EXPECT_EQ(blob(answer, head.at("files").at(0).at("bytes")), "<svg/>");
  EXPECT_EQ(blob(answer, head.at("journal")), "one two");
  auto const& message = head.at("messages").at(0);
  EXPECT_EQ(message.at("severity"), "warning");
  EXPECT_FALSE(message.at("text").get<std::string>().empty());
  EXPECT_EQ(message.at("place"), Json({{"x", 1}, {"y", 2}, {"width", 3}, {"height", 4}}));
}

TEST(ChangesAnswer, AJournalThatBeginsAnewForgetsWhatWasGathered) {
  Changes changes;
  changes.journal = "old";
  Changes next;
  next.journal = "new";
  next.is_journal_new = true;
  gather(changes, next);
  EXPECT_TRUE(changes.is_journal_new);
  EXPECT_EQ(changes.journal, "new");
}

TEST(ChangesAnswer, AJournalIsRecoveredWholeWhenEachOfItsBytesCounts) {
  Artist artist;
  artist.draw_circle({500, 500}, 200);
  auto const& journal = artist.journal;
  ASSERT_GT(journal.size(), 10U);
  auto const recovery = [](std::string const& text) {
    return recovery_of(Engine().recover(bytes_of(text)), text.size());
  };
  EXPECT_EQ(recovery(journal), Recovery::Whole);
  // What is appended to half a line would be lost with it.
  EXPECT_EQ(recovery(journal.substr(0, journal.size() - 5)), Recovery::InPart);
  EXPECT_EQ(recovery(journal + "x\nx\n"), Recovery::InPart);
  EXPECT_EQ(recovery("no journal"), Recovery::InPart);
  EXPECT_EQ(recovery(""), Recovery::InPart);
}

TEST(StateAnswer, NamesAndNumbersAreThoseOfTheProtocol) {
  Artist artist;
  artist.draw_circle({500, 500}, 200);
  artist.key("Enter");
  artist.act("fill", "#0a0B0c");
  auto const state = head_of(state_answer(artist.state(), artist.document()));
  EXPECT_EQ(state.at("mode"), "draw");
  EXPECT_EQ(state.at("tool"), "brush");
  EXPECT_EQ(state.at("ink"), "#22242b");
  EXPECT_EQ(state.at("language"), "en");
  EXPECT_TRUE(state.at("gapPx").is_null());
  EXPECT_TRUE(state.at("redo").is_null());
  EXPECT_FALSE(state.at("isBlank"));
  EXPECT_EQ(state.at("layers").size(), 1U);
  EXPECT_EQ(state.at("layers").at(0).at("look"), 1);
}

TEST(StateAnswer, EveryActionHasItsRow) {
  auto const rows = head_of(actions_answer());
  ASSERT_EQ(rows.size(), actions().size());
  for (auto const& row : rows) {
    EXPECT_EQ(find_action(row.at("name").get<std::string>())->english, row.at("labels").at("en"));
    auto const is_choice = row.at("argument") == "choice";
    EXPECT_EQ(is_choice, !row.at("choices").empty()) << row;
  }
  auto const look = std::find_if(rows.begin(), rows.end(),
                                 [](Json const& row) { return row.at("name") == "look"; });
  EXPECT_EQ(look->at("choices"), Json({"matcap", "textured", "lines"}));
}

TEST(SceneAnswer, WhatTheSceneBeforeHadIsNotSentAgain) {
  Artist artist;
  artist.draw_circle({500, 500}, 200);
  SceneSender sender;
  auto const first = head_of(sender.answer(artist.engine().scene()));
  auto const second = head_of(sender.answer(artist.engine().scene()));
  ASSERT_FALSE(first.at("chunks").empty());
  ASSERT_EQ(first.at("chunks").size(), second.at("chunks").size());
  for (auto const& chunk : first.at("chunks")) EXPECT_EQ(chunk.size(), 4U);
  for (auto const& chunk : second.at("chunks")) EXPECT_EQ(chunk.size(), 2U);
}

TEST(SceneAnswer, TheMeshIsSentOnceAndHasAsManyNumbersAsCorners) {
  Artist artist;
  artist.draw_circle({500, 500}, 200);
  artist.key("Enter");
  artist.key("2");
  artist.engine().work();
  SceneSender sender;
  auto const answer = sender.answer(artist.engine().scene());
  auto const model = head_of(answer).at("model");
  auto const bytes = [&](char const* name) {
    return model.at("mesh").at(name).at(1).get<std::size_t>();
  };
  auto const scene = artist.engine().scene();
  auto const triangles = scene.model->model->mesh.triangles.size();
  EXPECT_EQ(bytes("positions"), triangles * 9 * 4);
  EXPECT_EQ(bytes("normals"), triangles * 9 * 4);
  EXPECT_EQ(bytes("places"), triangles * 6 * 4);
  EXPECT_EQ(bytes("layers"), triangles * 3 * 4);
  EXPECT_EQ(bytes("texture"), scene.model->texture->picture.values.size() * 4);
  EXPECT_EQ(model.at("toView").size(), 12U);
  EXPECT_GT(model.at("shadow").at("rx"), 0);
  EXPECT_TRUE(head_of(sender.answer(scene)).at("model").at("mesh").is_null());
}

TEST(WorkShare, NeverGoesBackUntilOtherWorkBegins) {
  WorkShare share;
  EXPECT_EQ(share.enter("place"), 0);
  auto const later = share.enter("fit");
  EXPECT_GT(later, 0);
  EXPECT_EQ(share.enter("cut"), later);
  EXPECT_EQ(share.enter("a stage that nobody knows"), later);
  share.start();
  EXPECT_EQ(share.enter("join"), 0);
}

}  // namespace
}  // namespace inkflate::web
