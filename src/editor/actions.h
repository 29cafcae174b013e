// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "editor/events.h"
#include "editor/message.h"
#include "editor/view.h"

namespace inkflate {

/// Everything that can be done, each thing once: menus, shortcut lists, remapping and the help page are made from this table.

enum class Menu { File, Edit, View, Tool, Part, Model, Help };

/// What an action needs beside its name.
enum class ActionArgument { None, Number, Text, Colour, Place, Choice };

/// Where the keys of an action count. By its name it can be called anywhere.
enum class KeyModes { All, Draw, Model };  // Model: Inflate and Animate

/// What becomes of a key that is held down.
enum class KeyRepeat { Once, Again };

struct KeyChord {
  std::string key;  // as KeyEvent::key; letters small
  Modifiers modifiers = {};

  friend bool operator==(KeyChord const&, KeyChord const&) = default;
};

struct Action {
  std::string_view name;     // "undo": as events, recordings and remapping call it
  std::string_view english;  // "Undo"
  std::string_view czech;    // "Zpět"
  std::string_view keys;     // "Ctrl+Shift+Z, Ctrl+Y": default chords, the first is shown
  Menu menu = Menu::Edit;
  ActionArgument argument = ActionArgument::None;
  std::string_view choices = {};  // "on off": of a Choice
  KeyModes modes = KeyModes::All;
  KeyRepeat repeat = KeyRepeat::Once;
};

/// In the order of the menus.
std::span<Action const> actions();
/// Null: there is no such action.
Action const* find_action(std::string_view name);
/// Index in actions(); -1: none. As label of history entries.
int action_index(std::string_view name);
/// The other way round; empty: no such index.
std::string_view action_name(int index);

std::string_view label(Action const& action, Language language);
std::string_view label(Menu menu, Language language);

/// "Ctrl+Shift+Z" as a chord; nothing when it is none. The key is one sign, "Space", or the name of a key that types nothing. Tab is
/// none: it leads from one thing on the screen to the next.
std::optional<KeyChord> parse_chord(std::string_view text);
std::string chord_text(KeyChord const& chord);
/// "Ctrl+Y, Ctrl+Shift+Z"; an empty text is an empty list. Nothing when one of them is no chord, or there are more than 16.
std::optional<std::vector<KeyChord>> parse_chords(std::string_view text);

/// Whether a key, as KeyEvent::key or KeyChord::key, types a sign: it is one code point of UTF-8.
bool types_sign(std::string_view key);

/// Off: keys that type a sign do nothing without Ctrl or Alt (WCAG 2.1.4: who speaks to the computer types by chance).
enum class SingleKeys { On, Off };

/// Which key does what: the table's keys, and what a person changed.
class KeyMap {
 public:
  KeyMap();

  /// The action of a key; empty: none, or the key is held down and the action does not repeat. The exact chord wins. Else Shift does
  /// not count unless the key is a letter, and Alt does not where it made the sign (AltGr): keyboards of many countries have
  /// "+", "?" or "[" only there.
  std::string_view action_for(KeyEvent const& event, Mode mode) const;

  /// The action gets these chords and no other. Chords that another action had in the same mode are taken from it; those actions are
  /// returned.
  ///
  /// errors  BadInput (no such action, a text that is no chord)
  Result<std::vector<std::string>> remap(std::string_view action, std::string_view chords);
  void reset();
  void set_single_keys(SingleKeys single_keys);

  std::string chords_of(std::string_view action) const;  // "Ctrl+Shift+Z, Ctrl+Y"

 private:
  /// Index in actions(), -1: none.
  int find(KeyChord const& chord, Mode mode) const;

  std::vector<std::vector<KeyChord>> chords_;  // one list for each of actions()
  SingleKeys single_keys_ = SingleKeys::On;
};

}  // namespace inkflate
