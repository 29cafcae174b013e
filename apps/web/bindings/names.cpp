// SPDX-License-Identifier: Apache-2.0
#include "web/bindings/names.h"

#include <array>

namespace inkflate::web {
namespace {

/// Names in the order of the choices, the last of which is given.
template <auto last>
using Names = std::array<std::string_view, static_cast<std::size_t>(last) + 1>;

template <typename Choice, typename Names>
std::string_view pick(Names const& names, Choice choice) {
  return names[static_cast<std::size_t>(choice)];
}

constexpr Names<Mode::Animate> kModes = {"draw", "inflate", "animate"};
constexpr Names<Tool::Hand> kTools = {"brush",  "help_line", "eraser", "mark",
                                      "deform", "select",    "hand"};
constexpr Names<BendMode::Wire> kBendModes = {"body", "wire"};
constexpr Names<Shading::Lines> kShadings = {"matcap", "textured", "lines"};
constexpr Names<Language::Czech> kLanguages = {"en", "cs"};
constexpr Names<Menu::Help> kMenus = {"file", "edit", "view", "tool", "part", "model", "help"};
constexpr Names<ActionArgument::Choice> kArguments = {"none",   "number", "text",
                                                      "colour", "place",  "choice"};
constexpr Names<Severity::Problem> kSeverities = {"status", "warning", "problem"};

}  // namespace

std::string_view name_of(Mode mode) { return pick(kModes, mode); }
std::string_view name_of(Tool tool) { return pick(kTools, tool); }
std::string_view name_of(BendMode mode) { return pick(kBendModes, mode); }
std::string_view name_of(Shading shading) { return pick(kShadings, shading); }
std::string_view name_of(Language language) { return pick(kLanguages, language); }
std::string_view name_of(Menu menu) { return pick(kMenus, menu); }
std::string_view name_of(ActionArgument argument) { return pick(kArguments, argument); }
std::string_view name_of(Severity severity) { return pick(kSeverities, severity); }

}  // namespace inkflate::web
