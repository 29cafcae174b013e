// SPDX-License-Identifier: Apache-2.0
#include "house/include_rules.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

namespace inkflate::house {
namespace {

struct Floor {
  std::string_view folder;
  int height = 0;
};

// The picture in docs/ARCHITECTURE.md.
constexpr std::array kFloors = {
    Floor{"base", 0},     Floor{"geometry", 1}, Floor{"image", 2},    Floor{"mesh", 2},
    Floor{"solvers", 2},  Floor{"model", 3},    Floor{"ink", 4},      Floor{"simplify", 4},
    Floor{"deform", 4},   Floor{"assemble", 4}, Floor{"inflate", 4},  Floor{"animate", 4},
    Floor{"document", 4}, Floor{"render", 4},   Floor{"pipeline", 5}, Floor{"io", 5},
    Floor{"solidify", 4}, Floor{"editor", 6},   Floor{"cli", 7},      Floor{"desktop", 7},
    Floor{"web", 7},
};

struct LibraryRule {
  std::string_view prefix;   // of the included path
  std::string_view folders;  // that may use it, separated by spaces
};

constexpr std::array kLibraryRules = {
    LibraryRule{"Eigen/", "solvers"}, LibraryRule{"unsupported/Eigen/", "solvers"},
    LibraryRule{"stb", "io"},         LibraryRule{"nlohmann/", "io cli desktop web"},
    LibraryRule{"CLI/", "cli"},       LibraryRule{"emscripten", "web"},
    LibraryRule{"Q", "desktop"},      LibraryRule{"GL", "desktop web"},
    LibraryRule{"gtest/", ""},        LibraryRule{"rapidcheck", ""},
    LibraryRule{"benchmark/", ""},
};

std::optional<int> floor_of(std::string_view folder) {
  auto const found = std::find_if(kFloors.begin(), kFloors.end(),
                                  [&](Floor const& floor) { return floor.folder == folder; });
  if (found == kFloors.end()) return std::nullopt;
  return found->height;
}

bool starts_with_word(std::string_view words, std::string_view word) {
  std::istringstream stream{std::string(words)};
  for (std::string each; stream >> each;) {
    if (each == word) return true;
  }
  return false;
}

std::string_view first_folder(std::string_view path) {
  auto const slash = path.find('/');
  return slash == std::string_view::npos ? std::string_view{} : path.substr(0, slash);
}

std::string library_fault(std::string_view folder, std::string_view included) {
  for (auto const& rule : kLibraryRules) {
    if (included.starts_with(rule.prefix) && !starts_with_word(rule.folders, folder)) {
      return "may not use <" + std::string(included) + ">";
    }
  }
  return {};
}

std::string edge_fault(std::string_view folder, std::string_view included) {
  auto const target = first_folder(included);
  auto const here = floor_of(folder);
  auto const there = floor_of(target);
  if (!here) return "lies in a folder without a floor";
  if (!there) return "includes \"" + std::string(included) + "\", which names no folder of ours";
  if (target == folder || *there < *here) return {};
  return std::string("includes ") + (*there > *here ? "upward" : "a neighbour") + ": \"" +
         std::string(included) + "\"";
}

}  // namespace

std::vector<std::string> includes_of(std::string_view text) {
  std::vector<std::string> result;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) {
    line.erase(std::remove_if(line.begin(), line.end(),
                              [](char c) { return c == ' ' || c == '\t' || c == '\r'; }),
               line.end());
    std::string_view const directive = "#include";
    if (!line.starts_with(directive)) continue;
    line.erase(0, directive.size());
    auto const last = line.find_first_of("\">", 1);
    if (last != std::string::npos) result.push_back(line.substr(0, last + 1));
  }
  return result;
}

std::vector<std::string> include_faults(std::string_view path, std::string_view text) {
  std::vector<std::string> faults;
  auto const inside = path.substr(path.find('/') + 1);  // without src/ or apps/
  auto const folder = first_folder(inside);
  for (auto const& include : includes_of(text)) {
    std::string_view const included = std::string_view(include).substr(1, include.size() - 2);
    auto fault = library_fault(folder, included);
    if (fault.empty() && include.front() == '"') fault = edge_fault(folder, included);
    if (!fault.empty()) faults.push_back(std::string(path) + " " + fault);
  }
  return faults;
}

}  // namespace inkflate::house
