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

struct KeyChord {
  std::string key;  // as KeyEvent::key; letters small
  Modifiers modifiers = {};

  friend bool operator==(KeyChord const&, KeyChord const&) = default;
};

struct Action {
  std::string_view name;  // "undo": as events, recordings and remapping call it
  Menu menu = Menu::Edit;
  std::string_view english;  // "Undo"
  std::string_view czech;    // "Zpět"
  std::string_view keys;     // "Ctrl+Shift+Z, Ctrl+Y": default chords, the first is shown
  ActionArgument argument = ActionArgument::None;
};

/// In the order of the menus.
std::span<Action const> actions();
/// Null: there is no such action.
Action const* find_action(std::string_view name);
/// Index in actions(); -1: none. As label of history entries.
int action_index(std::string_view name);

std::string_view label(Action const& action, Language language);
std::string_view label(Menu menu, Language language);

/// "Ctrl+Shift+Z" as a chord; nothing when it is none.
std::optional<KeyChord> parse_chord(std::string_view text);
std::string chord_text(KeyChord const& chord);

enum class SingleKeys {
  On,
  Off
};  // Off: keys without Ctrl or Alt do nothing, but for Esc, Enter, Delete and arrows

/// Which key does what: the table's keys, and what a person changed.
class KeyMap {
 public:
  KeyMap();

  /// The action of a key; empty: none. Shift counts only where the chord names it or the key is a letter; a chord that exists for the mode wins.
  std::string_view action_for(KeyEvent const& event, Mode mode) const;

  /// The action gets these chords and no other. Chords that another action had are taken from it; those actions are returned.
  ///
  /// errors  BadInput (no such action, a text that is no chord)
  Result<std::vector<std::string>> remap(std::string_view action, std::string_view chords);
  void reset();
  void set_single_keys(SingleKeys single_keys);

  std::string chords_of(std::string_view action) const;  // "Ctrl+Shift+Z, Ctrl+Y"
};

}  // namespace inkflate
