// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "editor/message.h"

namespace inkflate {
namespace {

std::string say(Word word, Language language, std::string const& argument) {
  Message message;
  message.word = word;
  message.arguments = {argument};
  return text_of(message, language);
}

bool holds(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

TEST(Words, AreThereInBothLanguagesWithTheSameArguments) {
  for (int i = 0; i <= static_cast<int>(Word::ModelFault); ++i) {
    auto const english = say(static_cast<Word>(i), Language::English, "1972");
    auto const czech = say(static_cast<Word>(i), Language::Czech, "1972");
    EXPECT_FALSE(english.empty() || czech.empty()) << i;
    EXPECT_NE(english, czech);
    EXPECT_EQ(holds(english, "1972"), holds(czech, "1972")) << english;
    for (auto const& text : {english, czech}) {
      EXPECT_EQ(text.find_first_of("{}|!"), std::string::npos) << text;
      EXPECT_FALSE(holds(text, "layer"));
    }
  }
}

TEST(Words, CountAsTheLanguageDoes) {
  auto const gaps = [](Language language, char const* count) {
    return say(Word::ClosedGaps, language, count);
  };
  EXPECT_EQ(gaps(Language::English, "1"), "Closed 1 gap.");
  EXPECT_EQ(gaps(Language::English, "2"), "Closed 2 gaps.");
  EXPECT_EQ(gaps(Language::English, "0"), "Closed 0 gaps.");
  EXPECT_EQ(gaps(Language::Czech, "1"), "Uzavřena 1 mezera.");
  for (auto const* count : {"2", "3", "4"}) {
    EXPECT_EQ(gaps(Language::Czech, count), "Uzavřeny " + std::string(count) + " mezery.");
  }
  for (auto const* count : {"0", "5", "11", "22", "99999999999999"}) {
    EXPECT_EQ(gaps(Language::Czech, count), "Uzavřeno " + std::string(count) + " mezer.");
  }
}

TEST(Words, ActionsAreCalledByTheirLabels) {
  EXPECT_EQ(say(Word::Undone, Language::English, "help_line"), "Undone: Help line.");
  EXPECT_EQ(say(Word::Undone, Language::Czech, "help_line"), "Vráceno zpět: Pomocná čára.");
  EXPECT_EQ(say(Word::Redone, Language::English, "fly"), "Redone: fly.");
}

TEST(Words, ArgumentsAreTakenAsTheyAre) {
  EXPECT_EQ(say(Word::Opened, Language::English, "{0}|{action}"), "Opened {0}|{action}.");
}

TEST(Words, MissingArgumentsAreEmpty) {
  EXPECT_EQ(text_of({Severity::Status, Word::Opened}, Language::English), "Opened .");
}

}  // namespace
}  // namespace inkflate
