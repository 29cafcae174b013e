// SPDX-License-Identifier: Apache-2.0
#include "editor/actions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace inkflate {
namespace {

bool counts_in(KeyModes modes, Mode mode) {
  if (modes == KeyModes::All) return true;
  return (modes == KeyModes::Draw) == (mode == Mode::Draw);
}

TEST(Actions, HaveNamesOfTheirOwnBySmallLettersAndBars) {
  std::set<std::string_view> names;
  for (auto const& action : actions()) {
    EXPECT_TRUE(names.insert(action.name).second) << action.name;
    EXPECT_EQ(action.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos);
  }
}

TEST(Actions, AreFoundByTheirNames) {
  for (int i = 0; i < std::ssize(actions()); ++i) {
    EXPECT_EQ(action_index(actions()[i].name), i);
    EXPECT_EQ(find_action(actions()[i].name), &actions()[i]);
  }
  EXPECT_EQ(action_index("fly"), -1);
  EXPECT_EQ(find_action(""), nullptr);
}

TEST(Actions, StandInTheOrderOfTheMenus) {
  EXPECT_TRUE(std::is_sorted(actions().begin(), actions().end(),
                             [](Action const& a, Action const& b) { return a.menu < b.menu; }));
}

TEST(Actions, AreNamedInBothLanguagesInSentenceCase) {
  for (auto const& action : actions()) {
    auto const english = label(action, Language::English);
    auto const czech = label(action, Language::Czech);
    EXPECT_FALSE(english.empty() || czech.empty()) << action.name;
    EXPECT_NE(english, czech) << action.name;
    // One capital at the front and none after it, and no sign of excitement.
    auto const isnt_plain = [](char c) { return (c >= 'A' && c <= 'Z') || c == '!'; };
    EXPECT_TRUE(english[0] >= 'A' && english[0] <= 'Z') << english;
    EXPECT_TRUE(std::none_of(english.begin() + 1, english.end(), isnt_plain)) << english;
    EXPECT_TRUE(std::none_of(czech.begin() + 1, czech.end(), isnt_plain)) << czech;
    EXPECT_EQ(english.find("layer"), std::string::npos) << "people read of parts";
  }
}

// In a menu nothing may be called alike.
TEST(Actions, OfOneMenuDifferInTheirLabels) {
  for (auto const language : {Language::English, Language::Czech}) {
    std::set<std::pair<Menu, std::string_view>> labels;
    for (auto const& action : actions()) {
      EXPECT_TRUE(labels.insert({action.menu, label(action, language)}).second) << action.name;
    }
  }
}

TEST(Actions, MenusAreNamedInBothLanguages) {
  EXPECT_EQ(label(Menu::File, Language::English), "File");
  EXPECT_EQ(label(Menu::Edit, Language::Czech), "Úpravy");
  EXPECT_EQ(label(Menu::Help, Language::Czech), "Nápověda");
}

TEST(Actions, OnlyChoicesHaveChoices) {
  for (auto const& action : actions()) {
    EXPECT_EQ(action.choices.empty(), action.argument != ActionArgument::Choice) << action.name;
  }
}

// A key cannot tell a number.
TEST(Actions, OnlyThoseWithoutArgumentHaveKeys) {
  for (auto const& action : actions()) {
    EXPECT_TRUE(action.keys.empty() || action.argument == ActionArgument::None) << action.name;
  }
}

TEST(Actions, OfOneModeShareNoChord) {
  for (auto const mode : {Mode::Draw, Mode::Inflate, Mode::Animate}) {
    std::set<std::string> taken;
    for (auto const& action : actions()) {
      auto const chords = parse_chords(action.keys);
      ASSERT_TRUE(chords) << action.name;
      if (!counts_in(action.modes, mode)) continue;
      for (auto const& chord : *chords) {
        EXPECT_TRUE(taken.insert(chord_text(chord)).second) << chord_text(chord);
      }
    }
  }
}

}  // namespace
}  // namespace inkflate
