// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "house/source_files.h"

namespace inkflate::house {
namespace {

bool is_code(SourceFile const& file) {
  return has_extension(file, {".h", ".cpp", ".cmake", "CMakeLists.txt", ".py", ".sh", ".ts", ".tsx",
                              ".mjs", ".js", ".css", ".html", "run", "test"});
}

TEST(Files, CodeFilesNameTheirLicence) {
  for (auto const& file : source_files()) {
    if (!is_code(file)) continue;
    auto const head = file.text.substr(0, 120);
    EXPECT_NE(head.find("SPDX-License-Identifier: Apache-2.0"), std::string::npos) << file.path;
  }
}

TEST(Files, AreShort) {
  for (auto const& file : source_files()) {
    if (!is_code(file)) continue;
    EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), 400) << file.path;
  }
}

TEST(Files, EndWithOneNewline) {
  for (auto const& file : source_files()) {
    EXPECT_TRUE(file.text.ends_with('\n') && !file.text.ends_with("\n\n")) << file.path;
  }
}

// Unfinished work is not committed; a place on one machine means nothing on another.
TEST(Files, HoldNoLooseEndsAndNoPlacesOfOneMachine) {
  // Put together here, so that this file does not hold them.
  std::string const slash = "/";
  std::string const forbidden[] = {std::string("TO") + "DO", std::string("FIX") + "ME",
                                   slash + "home" + slash,   slash + "root" + slash,
                                   slash + "work" + slash,   std::string("registry.") + "npmjs"};
  for (auto const& file : source_files()) {
    for (auto const& word : forbidden) {
      EXPECT_EQ(file.text.find(word), std::string::npos) << file.path << " holds " << word;
    }
  }
}

}  // namespace
}  // namespace inkflate::house
