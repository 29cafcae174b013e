// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "editor/actions.h"
#include "io/numbers.h"

namespace inkflate {
namespace {

bool counts_in(KeyModes modes, Mode mode) {
  return modes == KeyModes::All || (modes == KeyModes::Draw) == (mode == Mode::Draw);
}

bool share_mode(KeyModes a, KeyModes b) {
  return a == KeyModes::All || b == KeyModes::All || a == b;
}

bool is_letter(std::string_view key) {
  return key.size() == 1 && lower_ascii(key[0]) >= 'a' && lower_ascii(key[0]) <= 'z';
}

bool holds(std::vector<KeyChord> const& chords, KeyChord const& chord) {
  return std::find(chords.begin(), chords.end(), chord) != chords.end();
}

/// Takes chords out of a list. False: none of them was there.
bool take_away(std::vector<KeyChord>& list, std::vector<KeyChord> const& chords) {
  return std::erase_if(list, [&](KeyChord const& chord) { return holds(chords, chord); }) > 0;
}

}  // namespace

KeyMap::KeyMap() { reset(); }

void KeyMap::reset() {
  chords_.clear();
  for (auto const& action : actions()) {
    auto chords = parse_chords(action.keys);
    CHECK(chords.has_value(), "a key of the table of actions is no chord");
    chords_.push_back(*std::move(chords));
  }
}

void KeyMap::set_single_keys(SingleKeys single_keys) { single_keys_ = single_keys; }

int KeyMap::find(KeyChord const& chord, Mode mode) const {
  bool const is_single = !chord.modifiers.is_ctrl && !chord.modifiers.is_alt;
  if (single_keys_ == SingleKeys::Off && is_single && types_sign(chord.key)) return -1;
  for (int i = 0; i < std::ssize(chords_); ++i) {
    if (counts_in(actions()[i].modes, mode) && holds(chords_[i], chord)) return i;
  }
  return -1;
}

std::string_view KeyMap::action_for(KeyEvent const& event, Mode mode) const {
  if (!event.is_press) return {};
  // By Shift alone, not by the letter's case: with CapsLock on, letters come large.
  KeyChord chord = {is_letter(event.key) ? lower_ascii(event.key) : event.key, event.modifiers};
  int found = find(chord, mode);
  if (found < 0 && !is_letter(chord.key)) {
    chord.modifiers.is_shift = false;
    found = find(chord, mode);
    if (found < 0 && chord.modifiers.is_alt && types_sign(chord.key)) {
      chord.modifiers = {};
      found = find(chord, mode);
    }
  }
  if (found < 0) return {};
  auto const& action = actions()[found];
  return event.is_repeat && action.repeat == KeyRepeat::Once ? std::string_view() : action.name;
}

Result<std::vector<std::string>> KeyMap::remap(std::string_view action, std::string_view chords) {
  int const index = action_index(action);
  if (index < 0) {
    return Error{ErrorCode::BadInput, "there is no action \"" + std::string(action) + "\""};
  }
  auto const parsed = parse_chords(chords);
  if (!parsed) {
    return Error{ErrorCode::BadInput,
                 "\"" + std::string(chords) + "\" is no key; write keys as \"Ctrl+Shift+Z, F2\""};
  }
  std::vector<std::string> robbed;
  for (int i = 0; i < std::ssize(chords_); ++i) {
    auto const& other = actions()[i];
    if (i == index || !share_mode(other.modes, actions()[index].modes)) continue;
    if (take_away(chords_[i], *parsed)) robbed.emplace_back(other.name);
  }
  chords_[index].clear();
  for (auto const& chord : *parsed) {
    if (!holds(chords_[index], chord)) chords_[index].push_back(chord);
  }
  return robbed;
}

std::string KeyMap::chords_of(std::string_view action) const {
  std::string text;
  int const index = action_index(action);
  if (index < 0) return text;
  for (auto const& chord : chords_[index]) {
    if (!text.empty()) text += ", ";
    text += chord_text(chord);
  }
  return text;
}

}  // namespace inkflate
