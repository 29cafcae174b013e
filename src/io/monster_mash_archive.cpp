// SPDX-License-Identifier: Apache-2.0
#include "io/monster_mash_archive.h"

#include <algorithm>

#include "io/numbers.h"
#include "io/svg_units.h"

namespace inkflate::monster_mash {
namespace {

struct Name {
  std::string folder;  // with its slash
  std::string file;
};

Name split_name(std::string_view path) {
  auto const lower = lower_ascii(path);
  auto const slash = lower.rfind('/');
  if (slash == lower.npos) return {"", lower};
  return {lower.substr(0, slash + 1), lower.substr(slash + 1)};
}

/// The number in "_org_012.png".
std::optional<int> number_in(std::string_view file, std::string_view kind) {
  std::string_view const end = ".png";
  if (file.size() <= kind.size() + end.size() || file.substr(0, kind.size()) != kind ||
      file.substr(file.size() - end.size()) != end) {
    return std::nullopt;
  }
  auto digits = file.substr(kind.size(), file.size() - kind.size() - end.size());
  auto const number = take_index(digits);
  return digits.empty() ? number : std::nullopt;
}

std::string_view take_word(std::string_view& text) {
  skip_separator(text, Separator::Blank);
  auto const word = text.substr(0, text.find_first_of(" \t\r\n\f"));
  text.remove_prefix(word.size());
  return word;
}

/// Takes "v. NUMBER"; false: the text is not one of the program's.
bool take_version(std::string_view& text) {
  if (take_word(text) != "v.") return false;
  take_word(text);
  return true;
}

std::optional<int> take_whole(std::string_view& text) {
  auto word = take_word(text);
  auto const number = take_index(word);
  return word.empty() ? number : std::nullopt;
}

}  // namespace

ProjectEntries find_project(std::span<ZipEntry const> entries) {
  auto const is_picture = [](ZipEntry const& entry) {
    auto const name = split_name(entry.name);
    return number_in(name.file, "_org_") || number_in(name.file, "_seg_");
  };
  ProjectEntries project;
  auto const first = std::find_if(entries.begin(), entries.end(), is_picture);
  if (first == entries.end()) return project;
  auto const folder = split_name(first->name).folder;
  std::map<int, PicturePair> pairs;
  for (auto const& entry : entries) {
    auto const name = split_name(entry.name);
    if (name.folder != folder) continue;
    if (auto const number = number_in(name.file, "_org_")) pairs[*number].outline = &entry;
    if (auto const number = number_in(name.file, "_seg_")) pairs[*number].region = &entry;
    if (name.file == "layers.txt") project.layers = &entry;
    if (name.file == "settings.txt") project.settings = &entry;
    if (name.file == "template.png") project.template_picture = &entry;
  }
  for (auto const& [number, pair] : pairs) project.pairs.push_back(pair);
  return project;
}

std::vector<int> depth_order(std::string_view layers_text, int pair_count) {
  std::map<int, int> pair_of_id;
  std::vector<int> order;
  std::vector<bool> is_placed(static_cast<std::size_t>(pair_count), false);
  auto const place = [&](int pair) {
    if (is_placed[static_cast<std::size_t>(pair)]) return;
    is_placed[static_cast<std::size_t>(pair)] = true;
    order.push_back(pair);
  };
  if (take_version(layers_text) && take_whole(layers_text)) {  // how many regions there ever were
    for (int pair = 0; pair < pair_count; ++pair) {
      auto const id = take_whole(layers_text);
      if (id) pair_of_id.emplace(*id, pair);
    }
    int const layer_count = take_whole(layers_text).value_or(0);
    for (int i = 0; i < layer_count; ++i) {
      auto const id = take_whole(layers_text);
      if (!id) break;
      auto const found = pair_of_id.find(*id);
      if (found != pair_of_id.end()) place(found->second);
    }
  }
  for (int pair = 0; pair < pair_count; ++pair) place(pair);
  return order;
}

std::optional<double> thickness_setting(std::string_view settings_text) {
  if (!take_version(settings_text)) return std::nullopt;
  while (true) {
    auto const key = take_word(settings_text);
    if (key.empty()) return std::nullopt;
    auto const value = take_word(settings_text);
    if (key == "defaultInflationAmount") return parse_thickness(value);
  }
}

}  // namespace inkflate::monster_mash
