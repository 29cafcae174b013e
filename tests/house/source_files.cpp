// SPDX-License-Identifier: Apache-2.0
#include "house/source_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace inkflate::house {
namespace {

namespace fs = std::filesystem;

bool is_written_by_people(std::string const& path) {
  static constexpr std::string_view endings[] = {".h",   ".cpp",  ".cmake", ".txt", ".json", ".py",
                                                 ".sh",  ".md",   ".ts",    ".tsx", ".mjs",  ".js",
                                                 ".css", ".html", "/run",   "/test"};
  std::string const rooted = "/" + path;
  return std::any_of(std::begin(endings), std::end(endings),
                     [&](std::string_view ending) { return rooted.ends_with(ending); });
}

bool is_skipped_folder(fs::path const& folder) {
  static constexpr std::string_view skipped[] = {".git",         "build", "out",
                                                 "node_modules", "data",  "corpus"};
  std::string const name = folder.filename().string();
  return std::find(std::begin(skipped), std::end(skipped), name) != std::end(skipped);
}

}  // namespace

std::vector<SourceFile> source_files() {
  std::vector<SourceFile> files;
  fs::path const top = INKFLATE_SOURCE_DIR;
  for (auto entry = fs::recursive_directory_iterator(top); entry != fs::end(entry); ++entry) {
    if (entry->is_directory()) {
      if (is_skipped_folder(entry->path())) entry.disable_recursion_pending();
      continue;
    }
    std::string const path = fs::relative(entry->path(), top).generic_string();
    if (!is_written_by_people(path)) continue;
    std::ifstream stream(entry->path(), std::ios::binary);
    std::string const text{std::istreambuf_iterator<char>(stream), {}};
    files.push_back({path, text});
  }
  std::sort(files.begin(), files.end(),
            [](SourceFile const& a, SourceFile const& b) { return a.path < b.path; });
  return files;
}

bool has_extension(SourceFile const& file, std::vector<std::string> const& extensions) {
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](std::string const& each) { return file.path.ends_with(each); });
}

}  // namespace inkflate::house
