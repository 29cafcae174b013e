// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace inkflate::house {

struct SourceFile {
  std::string path;  // from the top of the tree: "src/model/drawing.h"
  std::string text;
};

/// All files of the tree that people write: code, scripts, build files, documents; sorted by path.
std::vector<SourceFile> source_files();

/// Whether the path ends with one of these.
bool has_extension(SourceFile const& file, std::vector<std::string> const& extensions);

}  // namespace inkflate::house
