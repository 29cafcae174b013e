// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/read_zip.h"

namespace inkflate::monster_mash {

/// The two pictures of a region; one of them may be missing.
struct PicturePair {
  ZipEntry const* outline = nullptr;
  ZipEntry const* region = nullptr;
};

/// What of an archive is a project.
struct ProjectEntries {
  std::vector<PicturePair> pairs;  // by their numbers
  ZipEntry const* layers = nullptr;
  ZipEntry const* settings = nullptr;
  ZipEntry const* template_picture = nullptr;
};

/// Finds them in the folder where the first picture lies. Names are compared in any case of letters.
ProjectEntries find_project(std::span<ZipEntry const> entries);

/// The order of the pictures from back to front, by layers.txt: indices of pairs, each once. Pictures that the text does not know come last,
/// in front; where it says nothing of use, all in their own order.
std::vector<int> depth_order(std::string_view layers_text, int pair_count);

/// The thickness that settings.txt asks for, if it is one.
std::optional<double> thickness_setting(std::string_view settings_text);

}  // namespace inkflate::monster_mash
