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
    {"new", Menu::File, "New drawing", "Nová kresba", ""},
    {"open", Menu::File, "Open", "Otevřít", "Ctrl+O"},
    {"save", Menu::File, "Save", "Uložit", "Ctrl+S"},
    {"export", Menu::File, "Export", "Exportovat", "Ctrl+Shift+E"},
    {"export_as", Menu::File, "Export as", "Exportovat jako", "", Choice,
     "inkflate svg png zip glb obj stl 3mf"},
    {"open_template", Menu::File, "Add reference picture", "Vložit předlohu", ""},
    {"remove_template", Menu::File, "Remove reference picture", "Odebrat předlohu", ""},
    // Edit
    {"undo", Menu::Edit, "Undo", "Zpět", "Ctrl+Z", None, "", KeyModes::All, kAgain},
    {"redo", Menu::Edit, "Redo", "Znovu", "Ctrl+Shift+Z, Ctrl+Y", None, "", KeyModes::All, kAgain},
    {"delete", Menu::Edit, "Delete", "Smazat", "Delete, Backspace", None, "", kDraw},
    {"duplicate", Menu::Edit, "Duplicate", "Duplikovat", "Ctrl+D", None, "", kDraw},
    {"duplicate_behind", Menu::Edit, "Duplicate behind all", "Duplikovat za všechny", ""},
    {"duplicate_before", Menu::Edit, "Duplicate before all", "Duplikovat před všechny", ""},
    {"select_all", Menu::Edit, "Select all", "Vybrat vše", "Ctrl+A", None, "", kDraw},
    {"select", Menu::Edit, "Select parts", "Vybrat části", "", Text},
    {"cancel", Menu::Edit, "Cancel", "Zrušit", "Escape"},
    // View
    {"mode_draw", Menu::View, "Draw", "Kreslit", "1"},
    {"mode_inflate", Menu::View, "Inflate", "Nafouknout", "2"},
    {"mode_animate", Menu::View, "Animate", "Rozpohybovat", "3"},
    {"zoom_in", Menu::View, "Zoom in", "Přiblížit", "+, =", None, "", KeyModes::All, kAgain},
    {"zoom_out", Menu::View, "Zoom out", "Oddálit", "-", None, "", KeyModes::All, kAgain},
    {"zoom_actual", Menu::View, "Actual size", "Skutečná velikost", "Ctrl+0"},
    // The signs are what Shift makes of 1 and 2 on most keyboards.
    {"zoom_fit", Menu::View, "Show the whole drawing", "Zobrazit celou kresbu", "Shift+1, !"},
    {"zoom_selection", Menu::View, "Show the selection", "Zobrazit výběr", "Shift+2, @, \""},
    {"mirror_view", Menu::View, "Mirror view", "Zrcadlit pohled", "M", None, "", kDraw},
    {"grid", Menu::View, "Grid", "Mřížka", ""},
    // Tool
    {"brush", Menu::Tool, "Brush", "Štětec", "B, P", None, "", kDraw},
    {"help_line", Menu::Tool, "Help line", "Pomocná čára", "L", None, "", kDraw},
    {"eraser", Menu::Tool, "Eraser", "Guma", "E", None, "", kDraw},
    {"mark", Menu::Tool, "Mark", "Značka", "O", None, "", kDraw},
    {"select_tool", Menu::Tool, "Select", "Výběr", "V", None, "", kDraw},
    {"hand", Menu::Tool, "Hand", "Ruka", "H", None, "", kDraw},
    {"brush_larger", Menu::Tool, "Larger brush", "Větší štětec", "]", None, "", kDraw, kAgain},
    {"brush_smaller", Menu::Tool, "Smaller brush", "Menší štětec", "[", None, "", kDraw, kAgain},
    {"brush_size", Menu::Tool, "Brush size", "Velikost štětce", "", Number},
    {"ink_colour", Menu::Tool, "Ink colour", "Barva inkoustu", "", Colour},
    {"smoothing", Menu::Tool, "Smoothing", "Vyhlazování", "", Number},
    {"eraser_size", Menu::Tool, "Eraser size", "Velikost gumy", "", Number},
    {"simplify", Menu::Tool, "Simplify", "Zjednodušit", "Enter", None, "", kDraw},
    {"gap", Menu::Tool, "Largest gap", "Největší mezera", "", Text},
    {"mark_outside", Menu::Tool, "Mark as outside", "Označit jako vnějšek", "", Place},
    {"mark_inside", Menu::Tool, "Mark as inside", "Označit jako vnitřek", "", Place},
    // Part
    {"open_part", Menu::Part, "Edit lines of part", "Upravit čáry části", ""},
    {"redraw_part", Menu::Part, "Redraw part", "Překreslit část", ""},
    {"close_part", Menu::Part, "Stop editing part", "Ukončit úpravy části", ""},
    {"rename_part", Menu::Part, "Rename part", "Přejmenovat část", "", Text},
    {"thickness", Menu::Part, "Thickness", "Tloušťka", "", Number},
    {"fill", Menu::Part, "Fill colour", "Barva výplně", "", Colour},
    {"hide_part", Menu::Part, "Hide or show part", "Skrýt nebo zobrazit část", ""},
    {"lock_part", Menu::Part, "Lock or unlock part", "Zamknout nebo odemknout část", ""},
    {"move_part", Menu::Part, "Move to place in order", "Přesunout na místo v pořadí", "", Number},
    {"depth_nearer", Menu::Part, "Bring nearer", "Posunout blíž", "PageUp, Ctrl+]", None, "", kDraw,
     kAgain},
    {"depth_farther", Menu::Part, "Send farther", "Posunout dál", "PageDown, Ctrl+[", None, "",
     kDraw, kAgain},
    {"depth_front", Menu::Part, "Bring to front", "Přenést dopředu", "Home", None, "", kDraw},
    {"depth_back", Menu::Part, "Send to back", "Přenést dozadu", "End", None, "", kDraw},
    {"flip_horizontal", Menu::Part, "Flip horizontally", "Překlopit vodorovně", "Shift+H", None, "",
     kDraw},
    {"flip_vertical", Menu::Part, "Flip vertically", "Překlopit svisle", "Shift+V", None, "",
     kDraw},
    {"nudge_left", Menu::Part, "Nudge left", "Posunout doleva", "ArrowLeft", None, "", kDraw,
     kAgain},
    {"nudge_right", Menu::Part, "Nudge right", "Posunout doprava", "ArrowRight", None, "", kDraw,
     kAgain},
    {"nudge_up", Menu::Part, "Nudge up", "Posunout nahoru", "ArrowUp", None, "", kDraw, kAgain},
    {"nudge_down", Menu::Part, "Nudge down", "Posunout dolů", "ArrowDown", None, "", kDraw, kAgain},
    {"nudge_far_left", Menu::Part, "Nudge far left", "Posunout daleko doleva", "Shift+ArrowLeft",
     None, "", kDraw, kAgain},
    {"nudge_far_right", Menu::Part, "Nudge far right", "Posunout daleko doprava",
     "Shift+ArrowRight", None, "", kDraw, kAgain},
    {"nudge_far_up", Menu::Part, "Nudge far up", "Posunout daleko nahoru", "Shift+ArrowUp", None,
     "", kDraw, kAgain},
    {"nudge_far_down", Menu::Part, "Nudge far down", "Posunout daleko dolů", "Shift+ArrowDown",
     None, "", kDraw, kAgain},
    // Model
    {"look", Menu::Model, "Look", "Vzhled", "", Choice, "matcap textured lines"},
    {"turn_left", Menu::Model, "Turn left", "Otočit doleva", "ArrowLeft", None, "", kModel, kAgain},
    {"turn_right", Menu::Model, "Turn right", "Otočit doprava", "ArrowRight", None, "", kModel,
     kAgain},
    {"turn_up", Menu::Model, "Turn up", "Otočit nahoru", "ArrowUp", None, "", kModel, kAgain},
    {"turn_down", Menu::Model, "Turn down", "Otočit dolů", "ArrowDown", None, "", kModel, kAgain},
    {"reset_turn", Menu::Model, "View from the front", "Pohled zepředu", ""},
    // Help
    {"help", Menu::Help, "Help", "Nápověda", "?"},
    {"palette", Menu::Help, "Find an action", "Najít akci", "Ctrl+K, Ctrl+/"},
    {"language", Menu::Help, "Language", "Jazyk", "", Choice, "en cs"},
    {"single_keys", Menu::Help, "Single-key shortcuts", "Zkratky jednou klávesou", "", Choice,
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
