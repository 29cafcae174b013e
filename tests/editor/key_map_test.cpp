// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "editor/actions.h"

namespace inkflate {
namespace {

constexpr Modifiers kShift = {true, false, false};
constexpr Modifiers kCtrl = {false, true, false};
constexpr Modifiers kAltGr = {false, true, true};

std::string action_of(KeyMap const& keys, std::string const& key, Modifiers modifiers = {},
                      Mode mode = Mode::Draw) {
  KeyEvent event;
  event.key = key;
  event.modifiers = modifiers;
  return std::string(keys.action_for(event, mode));
}

TEST(KeyChord, TextIsReadBackAsTheSameChord) {
  for (auto const* text : {"Ctrl+Shift+Z", "Ctrl+Alt+Shift+F12", "+", "Ctrl++", ",", "Ctrl+,",
                           "Space", "Ctrl+Space", "ArrowLeft", "Alt+ě", "?", "1", "€", "𝄞"}) {
    auto const chord = parse_chord(text);
    ASSERT_TRUE(chord) << text;
    EXPECT_EQ(chord_text(*chord), text);
  }
}

TEST(KeyChord, IsReadInAnyCaseAndOrder) {
  EXPECT_EQ(parse_chord(" shift+CTRL+z "), (KeyChord{"z", {true, true, false}}));
  EXPECT_EQ(parse_chord("Cmd+enter"), (KeyChord{"Enter", kCtrl}));
  EXPECT_EQ(parse_chord("space"), (KeyChord{" ", {}}));
}

TEST(KeyChord, OtherTextsAreNone) {
  for (auto const* text :
       {"", " ", "Ctrl", "Ctrl+", "Ctrl+Shift+", "Zz", "Tab", "Ctrl+Ctrl+Z", "F13", "\n", "\x7f",
        "\xff", "\xc4", "\xc4z", "\xe2\x82", "ěě", "a very long name of a key"}) {
    EXPECT_FALSE(parse_chord(text)) << text;
  }
}

TEST(KeyChord, ListsAreSeparatedByCommasWhichAreKeysToo) {
  EXPECT_EQ(parse_chords("")->size(), 0U);
  EXPECT_EQ(parse_chords("A,B")->size(), 2U);
  EXPECT_EQ(parse_chords("Ctrl+,, ,, +")->size(), 3U);
  EXPECT_EQ(parse_chords("Ctrl+,, ,, +")->at(1).key, ",");
  for (auto const* text : {"A,", "A, nothing", "A B", "nothing, A"}) {
    EXPECT_FALSE(parse_chords(text)) << text;
  }
  std::string many = "a";
  for (int i = 0; i < 20; ++i) many += ", b";
  EXPECT_FALSE(parse_chords(many));
}

TEST(KeyMap, EveryKeyOfTheTableDoesItsAction) {
  KeyMap const keys;
  for (auto const& action : actions()) {
    auto const mode = action.modes == KeyModes::Model ? Mode::Inflate : Mode::Draw;
    auto const chords = parse_chords(action.keys).value();
    for (auto const& chord : chords) {
      EXPECT_EQ(action_of(keys, chord.key, chord.modifiers, mode), action.name);
    }
  }
}

TEST(KeyMap, ArrowsMoveThePartAndTurnTheModel) {
  KeyMap const keys;
  EXPECT_EQ(action_of(keys, "ArrowLeft"), "nudge_left");
  EXPECT_EQ(action_of(keys, "ArrowLeft", kShift), "nudge_far_left");
  EXPECT_EQ(action_of(keys, "ArrowLeft", {}, Mode::Inflate), "turn_left");
  EXPECT_EQ(action_of(keys, "ArrowLeft", {}, Mode::Animate), "turn_left");
}

TEST(KeyMap, KeysOfToolsCountOnlyWhereOneDraws) {
  KeyMap const keys;
  EXPECT_EQ(action_of(keys, "b"), "brush");
  EXPECT_EQ(action_of(keys, "b", {}, Mode::Inflate), "");
  EXPECT_EQ(action_of(keys, "1", {}, Mode::Inflate), "mode_draw");
}

TEST(KeyMap, SignsCountWhereverAKeyboardHasThem) {
  KeyMap const keys;
  EXPECT_EQ(action_of(keys, "+"), "zoom_in");
  EXPECT_EQ(action_of(keys, "+", kShift), "zoom_in");
  EXPECT_EQ(action_of(keys, "?", kShift), "help");
  EXPECT_EQ(action_of(keys, "["), "brush_smaller");
  EXPECT_EQ(action_of(keys, "[", kAltGr), "brush_smaller");
  EXPECT_EQ(action_of(keys, "[", kCtrl), "depth_farther");
  EXPECT_EQ(action_of(keys, "!", kShift), "zoom_fit");
  EXPECT_EQ(action_of(keys, "1", kShift), "zoom_fit");
  EXPECT_EQ(action_of(keys, "Enter", kShift), "simplify");
}

TEST(KeyMap, LettersGoByShiftAndNotByTheirCase) {
  KeyMap const keys;
  EXPECT_EQ(action_of(keys, "H"), "hand");  // CapsLock
  EXPECT_EQ(action_of(keys, "h", kShift), "flip_horizontal");
  EXPECT_EQ(action_of(keys, "H", kShift), "flip_horizontal");
  EXPECT_EQ(action_of(keys, "B", kShift), "");
  EXPECT_EQ(action_of(keys, "z", {true, true, false}), "redo");
  EXPECT_EQ(action_of(keys, "b", kAltGr), "");
}

TEST(KeyMap, OtherKeysDoNothing) {
  KeyMap const keys;
  for (auto const* key : {"", "Tab", "F5", "Dead", "é", "\xff", "Shift"}) {
    EXPECT_EQ(action_of(keys, key), "");
  }
  EXPECT_EQ(action_of(keys, "Enter", kAltGr), "");
}

TEST(KeyMap, ReleasesDoNothingAndOnlySomeActionsRepeat) {
  KeyMap const keys;
  KeyEvent event;
  event.key = "m";
  EXPECT_EQ(keys.action_for(event, Mode::Draw), "mirror_view");
  event.is_repeat = true;
  EXPECT_EQ(keys.action_for(event, Mode::Draw), "");
  event.key = "]";
  EXPECT_EQ(keys.action_for(event, Mode::Draw), "brush_larger");
  event.is_press = false;
  EXPECT_EQ(keys.action_for(event, Mode::Draw), "");
}

TEST(KeyMap, SingleKeysCanBeSwitchedOff) {
  KeyMap keys;
  keys.set_single_keys(SingleKeys::Off);
  for (auto const* key : {"b", "+", "?", "1", "["}) EXPECT_EQ(action_of(keys, key), "") << key;
  EXPECT_EQ(action_of(keys, "h", kShift), "");
  EXPECT_EQ(action_of(keys, "[", kAltGr), "");
  EXPECT_EQ(action_of(keys, "z", kCtrl), "undo");
  for (auto const* key : {"Enter", "Escape", "Delete", "ArrowUp", "PageUp"}) {
    EXPECT_NE(action_of(keys, key), "") << key;
  }
  keys.set_single_keys(SingleKeys::On);
  EXPECT_EQ(action_of(keys, "b"), "brush");
}

TEST(KeyMap, RemappedActionHasItsNewChordsAndNoOther) {
  KeyMap keys;
  auto const robbed = keys.remap("eraser", "X, ctrl+f2, X");
  ASSERT_TRUE(robbed);
  EXPECT_TRUE(robbed->empty());
  EXPECT_EQ(keys.chords_of("eraser"), "X, Ctrl+F2");
  EXPECT_EQ(action_of(keys, "x"), "eraser");
  EXPECT_EQ(action_of(keys, "F2", kCtrl), "eraser");
  EXPECT_EQ(action_of(keys, "e"), "");
  ASSERT_TRUE(keys.remap("eraser", ""));
  EXPECT_EQ(keys.chords_of("eraser"), "");
}

TEST(KeyMap, ChordIsTakenFromWhoHadItInTheSameMode) {
  KeyMap keys;
  auto const robbed = keys.remap("eraser", "B, Ctrl+Z");
  ASSERT_TRUE(robbed);
  EXPECT_EQ(*robbed, std::vector<std::string>({"undo", "brush"}));
  EXPECT_EQ(action_of(keys, "b"), "eraser");
  EXPECT_EQ(action_of(keys, "p"), "brush");
  auto const none = keys.remap("eraser", "PageUp");
  ASSERT_TRUE(none);
  EXPECT_EQ(*none, std::vector<std::string>({"depth_nearer"}));
  // The model's arrows stay; those of the drawing are taken.
  auto const arrows = keys.remap("eraser", "ArrowUp");
  ASSERT_TRUE(arrows);
  EXPECT_EQ(*arrows, std::vector<std::string>({"nudge_up"}));
  EXPECT_EQ(action_of(keys, "ArrowUp", {}, Mode::Inflate), "turn_up");
}

TEST(KeyMap, ResetBringsTheTablesKeysBack) {
  KeyMap keys;
  ASSERT_TRUE(keys.remap("eraser", "B"));
  keys.reset();
  for (auto const& action : actions()) {
    EXPECT_EQ(parse_chords(keys.chords_of(action.name)), parse_chords(action.keys));
  }
}

TEST(KeyMap, RefusesWhatItDoesNotKnowAndChangesNothing) {
  KeyMap keys;
  for (auto const& failed : {keys.remap("fly", "B"), keys.remap("eraser", "B, nothing")}) {
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().code, ErrorCode::BadInput);
  }
  EXPECT_EQ(action_of(keys, "b"), "brush");
  EXPECT_EQ(action_of(keys, "e"), "eraser");
  EXPECT_EQ(keys.chords_of("fly"), "");
}

}  // namespace
}  // namespace inkflate
