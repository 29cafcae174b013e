// SPDX-License-Identifier: Apache-2.0
#include "support/action_table.h"

#include "editor/actions.h"

namespace inkflate::support {
namespace {

constexpr char kHead[] =
    "# Actions\n"
    "\n"
    "Everything that can be done, each thing once: menus, buttons, keys and recordings call "
    "actions by these names. Ctrl is Cmd\n"
    "where that is the custom; every key can be changed. This page is printed by `action_table`; a "
    "test compares them.\n";

/// Where the keys count; empty: everywhere.
std::string_view modes_text(KeyModes modes) {
  if (modes == KeyModes::Draw) return "Draw";
  return modes == KeyModes::Model ? "Inflate, Animate" : "";
}

std::string argument_text(Action const& action) {
  switch (action.argument) {
    case ActionArgument::None:
      return "";
    case ActionArgument::Number:
      return "a number";
    case ActionArgument::Text:
      return "a text";
    case ActionArgument::Colour:
      return "a colour";
    case ActionArgument::Place:
      return "a place";
    case ActionArgument::Choice:
      return "one of " + std::string(action.choices);
  }
  return "";
}

/// As code, so that no sign is taken for markup.
std::string keys_text(Action const& action) {
  std::string text;
  for (auto const& chord : parse_chords(action.keys).value_or(std::vector<KeyChord>())) {
    text += (text.empty() ? "`" : ", `") + chord_text(chord) + "`";
  }
  return text;
}

std::string row(Action const& action) {
  std::string text = "| `" + std::string(action.name) + "` | ";
  text += std::string(action.english) + " | " + std::string(action.czech) + " | ";
  text += keys_text(action) + " | " + std::string(modes_text(action.modes)) + " | ";
  return text + argument_text(action) + " |\n";
}

}  // namespace

std::string action_table() {
  std::string text = kHead;
  Action const* before = nullptr;
  for (auto const& action : actions()) {
    if (!before || before->menu != action.menu) {
      text += "\n## " + std::string(label(action.menu, Language::English)) + " (";
      text += std::string(label(action.menu, Language::Czech)) + ")\n\n";
      text += "| name | English | Czech | keys | only in | takes |\n";
      text += "| --- | --- | --- | --- | --- | --- |\n";
    }
    text += row(action);
    before = &action;
  }
  return text;
}

std::string action_names() {
  std::string text =
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Printed by the tool action_names from src/editor/actions.cpp; a test compares them.\n"
      "\n"
      "export const actionNames = [\n";
  for (auto const& action : actions()) text += "  \"" + std::string(action.name) + "\",\n";
  text +=
      "] as const;\n"
      "\n"
      "export type ActionName = (typeof actionNames)[number];\n";
  return text;
}

}  // namespace inkflate::support
