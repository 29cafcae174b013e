// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <string_view>

#include "editor/actions.h"
#include "io/numbers.h"

namespace inkflate {
namespace {

constexpr std::string_view kSpace = "Space";
constexpr std::size_t kLongestKeyName = 10;  // bytes, of those below
constexpr std::ptrdiff_t kMostChords = 16;   // of one action; nobody needs more

/// Keys that type nothing, as browsers name them.
constexpr std::string_view kNamedKeys[] = {
    "Enter", "Escape", "Delete",    "Backspace",  "Insert",  "PageUp",    "PageDown",
    "Home",  "End",    "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "F1",
    "F2",    "F3",     "F4",        "F5",         "F6",      "F7",        "F8",
    "F9",    "F10",    "F11",       "F12",
};

struct ModifierName {
  std::string_view prefix;
  bool Modifiers::*member;
};

constexpr ModifierName kModifiers[] = {{"ctrl+", &Modifiers::is_ctrl},
                                       {"cmd+", &Modifiers::is_ctrl},
                                       {"alt+", &Modifiers::is_alt},
                                       {"shift+", &Modifiers::is_shift}};

/// Takes "Ctrl+" and the like off the front. False: none stands there, or one for the second time.
bool take_modifier(std::string_view& text, Modifiers& modifiers) {
  for (auto const& row : kModifiers) {
    if (lower_ascii(text.substr(0, row.prefix.size())) != row.prefix) continue;
    if (modifiers.*row.member) return false;
    text.remove_prefix(row.prefix.size());
    modifiers.*row.member = true;
    return true;
  }
  return false;
}

/// The key as KeyChord has it; empty: there is none of this name.
std::string parse_key(std::string_view text) {
  if (text.size() > kLongestKeyName) return {};
  auto const small = lower_ascii(text);
  if (small == lower_ascii(kSpace)) return " ";
  for (auto const name : kNamedKeys) {
    if (small == lower_ascii(name)) return std::string(name);
  }
  return types_sign(text) ? small : std::string();
}

}  // namespace

bool types_sign(std::string_view key) {
  if (key.empty()) return false;
  auto const first = static_cast<unsigned char>(key[0]);
  if (first < 0x80) return key.size() == 1 && first >= 0x20 && first != 0x7f;
  // One code point of UTF-8: its first byte tells how many others follow.
  std::size_t const length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || key.size() != length) return false;
  for (auto const c : key.substr(1)) {
    if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) return false;
  }
  return true;
}

std::optional<KeyChord> parse_chord(std::string_view text) {
  KeyChord chord;
  text = trimmed(text);
  while (take_modifier(text, chord.modifiers)) {
  }
  chord.key = parse_key(text);
  if (chord.key.empty()) return std::nullopt;
  return chord;
}

std::string chord_text(KeyChord const& chord) {
  std::string text;
  if (chord.modifiers.is_ctrl) text += "Ctrl+";
  if (chord.modifiers.is_alt) text += "Alt+";
  if (chord.modifiers.is_shift) text += "Shift+";
  if (chord.key == " ") return text.append(kSpace);
  bool const is_letter = chord.key.size() == 1 && chord.key[0] >= 'a' && chord.key[0] <= 'z';
  return text +
         (is_letter ? std::string(1, static_cast<char>(chord.key[0] - 'a' + 'A')) : chord.key);
}

std::optional<std::vector<KeyChord>> parse_chords(std::string_view text) {
  std::vector<KeyChord> chords;
  text = trimmed(text);
  while (!text.empty()) {
    // A comma may be a key too: it ends a chord only where there is one before it.
    auto end = text.find(',');
    while (end != std::string_view::npos && !parse_chord(text.substr(0, end))) {
      end = text.find(',', end + 1);
    }
    auto const chord = parse_chord(text.substr(0, end));
    if (!chord || std::ssize(chords) == kMostChords) return std::nullopt;
    chords.push_back(*chord);
    if (end == std::string_view::npos) break;
    text = trimmed(text.substr(end + 1));
    if (text.empty()) return std::nullopt;
  }
  return chords;
}

}  // namespace inkflate
