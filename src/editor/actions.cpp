// SPDX-License-Identifier: Apache-2.0
#include "editor/actions.h"

#include <iterator>

namespace inkflate {
namespace {

using enum ActionArgument;
constexpr auto kDraw = KeyModes::Draw;
constexpr auto kModel = KeyModes::Model;
constexpr auto kAgain = KeyRepeat::Again;

constexpr Action kActions[] = {
    // File
    {"new", "New drawing", "Nová kresba", "", Menu::File},
    {"open", "Open", "Otevřít", "Ctrl+O", Menu::File},
    {"save", "Save", "Uložit", "Ctrl+S", Menu::File},
    {"export", "Export", "Exportovat", "Ctrl+Shift+E", Menu::File},
    {"export_as", "Export as", "Exportovat jako", "", Menu::File, Choice,
     "inkflate svg png zip glb obj stl 3mf"},
    {"open_template", "Add reference picture", "Vložit předlohu", "", Menu::File},
    {"remove_template", "Remove reference picture", "Odebrat předlohu", "", Menu::File},
    // Edit
    {"undo", "Undo", "Zpět", "Ctrl+Z", Menu::Edit, None, "", KeyModes::All, kAgain},
    {"redo", "Redo", "Znovu", "Ctrl+Shift+Z, Ctrl+Y", Menu::Edit, None, "", KeyModes::All, kAgain},
    {"delete", "Delete", "Smazat", "Delete, Backspace", Menu::Edit, None, "", kDraw},
    {"duplicate", "Duplicate", "Duplikovat", "Ctrl+D", Menu::Edit, None, "", kDraw},
    {"duplicate_behind", "Duplicate behind all", "Duplikovat za všechny", "", Menu::Edit},
    {"duplicate_before", "Duplicate before all", "Duplikovat před všechny", "", Menu::Edit},
    {"select_all", "Select all", "Vybrat vše", "Ctrl+A", Menu::Edit, None, "", kDraw},
    {"select", "Select parts", "Vybrat části", "", Menu::Edit, Text},
    {"cancel", "Cancel", "Zrušit", "Escape", Menu::Edit},
    // View
    {"mode_draw", "Draw", "Kreslit", "1", Menu::View},
    {"mode_inflate", "Inflate", "Nafouknout", "2", Menu::View},
    {"mode_animate", "Animate", "Rozpohybovat", "3", Menu::View},
    {"zoom_in", "Zoom in", "Přiblížit", "+, =", Menu::View, None, "", KeyModes::All, kAgain},
    {"zoom_out", "Zoom out", "Oddálit", "-", Menu::View, None, "", KeyModes::All, kAgain},
    {"zoom_actual", "Actual size", "Skutečná velikost", "Ctrl+0", Menu::View},
    // The signs are what Shift makes of 1 and 2 on most keyboards.
    {"zoom_fit", "Show the whole drawing", "Zobrazit celou kresbu", "Shift+1, !", Menu::View},
    {"zoom_selection", "Show the selection", "Zobrazit výběr", "Shift+2, @, \"", Menu::View},
    {"show_place", "Show a place", "Zobrazit místo", "", Menu::View, Text},
    {"mirror_view", "Mirror view", "Zrcadlit pohled", "M", Menu::View, None, "", kDraw},
    {"grid", "Grid", "Mřížka", "", Menu::View},
    // Tool
    {"brush", "Brush", "Štětec", "B, P", Menu::Tool, None, "", kDraw},
    {"help_line", "Help line", "Pomocná čára", "L", Menu::Tool, None, "", kDraw},
    {"eraser", "Eraser", "Guma", "E", Menu::Tool, None, "", kDraw},
    {"mark", "Mark", "Značka", "O", Menu::Tool, None, "", kDraw},
    {"deform", "Deform", "Deformovat", "D", Menu::Tool, None, "", kDraw},
    {"select_tool", "Select", "Výběr", "V", Menu::Tool, None, "", kDraw},
    {"hand", "Hand", "Ruka", "H", Menu::Tool, None, "", kDraw},
    {"brush_larger", "Larger brush", "Větší štětec", "]", Menu::Tool, None, "", kDraw, kAgain},
    {"brush_smaller", "Smaller brush", "Menší štětec", "[", Menu::Tool, None, "", kDraw, kAgain},
    {"brush_size", "Brush size", "Velikost štětce", "", Menu::Tool, Number},
    {"ink_colour", "Ink colour", "Barva inkoustu", "", Menu::Tool, Colour},
    {"smoothing", "Smoothing", "Vyhlazování", "", Menu::Tool, Number},
    {"eraser_size", "Eraser size", "Velikost gumy", "", Menu::Tool, Number},
    {"simplify", "Simplify", "Zjednodušit", "Enter", Menu::Tool, None, "", kDraw},
    {"gap", "Largest gap", "Největší mezera", "", Menu::Tool, Text},
    {"mark_outside", "Mark as outside", "Označit jako vnějšek", "", Menu::Tool, Place},
    {"mark_inside", "Mark as inside", "Označit jako vnitřek", "", Menu::Tool, Place},
    {"bend_mode", "Bend as", "Ohýbat jako", "", Menu::Tool, Choice, "body wire"},
    {"bend_body", "Stiffness of the body", "Tuhost těla", "", Menu::Tool, Number},
    {"bend_reach", "Reach of a bend", "Dosah ohybu", "", Menu::Tool, Text},
    {"add_pin", "Add pin", "Přidat špendlík", "Shift+D", Menu::Tool, None, "", kDraw},
    {"next_pin", "Next pin", "Další špendlík", "N", Menu::Tool, None, "", kDraw, kAgain},
    {"previous_pin", "Previous pin", "Předchozí špendlík", "Shift+N", Menu::Tool, None, "", kDraw,
     kAgain},
    {"turn_pin_left", "Turn pin left", "Otočit špendlík doleva", ",", Menu::Tool, None, "", kDraw,
     kAgain},
    {"turn_pin_right", "Turn pin right", "Otočit špendlík doprava", ".", Menu::Tool, None, "",
     kDraw, kAgain},
    {"free_pin", "Let pin turn freely", "Nechat špendlík volně otáčet", "", Menu::Tool},
    {"delete_pins", "Delete pins of part", "Smazat špendlíky části", "", Menu::Tool},
    // Part
    {"open_part", "Edit lines of part", "Upravit čáry části", "", Menu::Part},
    {"redraw_part", "Redraw part", "Překreslit část", "", Menu::Part},
    {"close_part", "Stop editing part", "Ukončit úpravy části", "", Menu::Part},
    {"rename_part", "Rename part", "Přejmenovat část", "", Menu::Part, Text},
    {"thickness", "Thickness", "Tloušťka", "", Menu::Part, Number},
    {"fill", "Fill colour", "Barva výplně", "", Menu::Part, Colour},
    {"hide_part", "Hide or show part", "Skrýt nebo zobrazit část", "", Menu::Part},
    {"lock_part", "Lock or unlock part", "Zamknout nebo odemknout část", "", Menu::Part},
    {"move_part", "Move to place in order", "Přesunout na místo v pořadí", "", Menu::Part, Number},
    {"depth_nearer", "Bring nearer", "Posunout blíž", "PageUp, Ctrl+]", Menu::Part, None, "", kDraw,
     kAgain},
    {"depth_farther", "Send farther", "Posunout dál", "PageDown, Ctrl+[", Menu::Part, None, "",
     kDraw, kAgain},
    {"depth_front", "Bring to front", "Přenést dopředu", "Home", Menu::Part, None, "", kDraw},
    {"depth_back", "Send to back", "Přenést dozadu", "End", Menu::Part, None, "", kDraw},
    {"flip_horizontal", "Flip horizontally", "Překlopit vodorovně", "Shift+H", Menu::Part, None, "",
     kDraw},
    {"flip_vertical", "Flip vertically", "Překlopit svisle", "Shift+V", Menu::Part, None, "",
     kDraw},
    {"nudge_left", "Nudge left", "Posunout doleva", "ArrowLeft", Menu::Part, None, "", kDraw,
     kAgain},
    {"nudge_right", "Nudge right", "Posunout doprava", "ArrowRight", Menu::Part, None, "", kDraw,
     kAgain},
    {"nudge_up", "Nudge up", "Posunout nahoru", "ArrowUp", Menu::Part, None, "", kDraw, kAgain},
    {"nudge_down", "Nudge down", "Posunout dolů", "ArrowDown", Menu::Part, None, "", kDraw, kAgain},
    {"nudge_far_left", "Nudge far left", "Posunout daleko doleva", "Shift+ArrowLeft", Menu::Part,
     None, "", kDraw, kAgain},
    {"nudge_far_right", "Nudge far right", "Posunout daleko doprava", "Shift+ArrowRight",
     Menu::Part, None, "", kDraw, kAgain},
    {"nudge_far_up", "Nudge far up", "Posunout daleko nahoru", "Shift+ArrowUp", Menu::Part, None,
     "", kDraw, kAgain},
    {"nudge_far_down", "Nudge far down", "Posunout daleko dolů", "Shift+ArrowDown", Menu::Part,
     None, "", kDraw, kAgain},
    // Model
    {"look", "Look", "Vzhled", "", Menu::Model, Choice, "matcap textured lines"},
    {"turn_left", "Turn left", "Otočit doleva", "ArrowLeft", Menu::Model, None, "", kModel, kAgain},
    {"turn_right", "Turn right", "Otočit doprava", "ArrowRight", Menu::Model, None, "", kModel,
     kAgain},
    {"turn_up", "Turn up", "Otočit nahoru", "ArrowUp", Menu::Model, None, "", kModel, kAgain},
    {"turn_down", "Turn down", "Otočit dolů", "ArrowDown", Menu::Model, None, "", kModel, kAgain},
    {"reset_turn", "View from the front", "Pohled zepředu", "", Menu::Model},
    // Help
    {"help", "Help", "Nápověda", "?", Menu::Help},
    {"palette", "Find an action", "Najít akci", "Ctrl+K, Ctrl+/", Menu::Help},
    {"language", "Language", "Jazyk", "", Menu::Help, Choice, "en cs"},
    {"single_keys", "Single-key shortcuts", "Zkratky jednou klávesou", "", Menu::Help, Choice,
     "on off"},
};

struct MenuLabel {
  std::string_view english;
  std::string_view czech;
};

// In the order of Menu.
constexpr MenuLabel kMenus[] = {
    {"File", "Soubor"}, {"Edit", "Úpravy"}, {"View", "Zobrazení"}, {"Tool", "Nástroj"},
    {"Part", "Část"},   {"Model", "Model"}, {"Help", "Nápověda"},
};
static_assert(std::size(kMenus) == static_cast<std::size_t>(Menu::Help) + 1);

}  // namespace

std::span<Action const> actions() { return kActions; }

int action_index(std::string_view name) {
  for (int i = 0; i < std::ssize(kActions); ++i) {
    if (kActions[i].name == name) return i;
  }
  return -1;
}

std::string_view action_name(int index) {
  bool const is_known = index >= 0 && index < std::ssize(actions());
  return is_known ? actions()[static_cast<std::size_t>(index)].name : std::string_view();
}

Action const* find_action(std::string_view name) {
  int const index = action_index(name);
  return index < 0 ? nullptr : &kActions[index];
}

std::string_view label(Action const& action, Language language) {
  return language == Language::Czech ? action.czech : action.english;
}

std::string_view label(Menu menu, Language language) {
  auto const& row = kMenus[static_cast<std::size_t>(menu)];
  return language == Language::Czech ? row.czech : row.english;
}

}  // namespace inkflate
