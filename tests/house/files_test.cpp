// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "house/source_files.h"

namespace inkflate::house {
namespace {

bool is_code(SourceFile const& file) {
  return has_extension(file, {".h", ".cpp", ".cmake", "CMakeLists.txt", ".py", ".sh", "run", "test"});
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

// Unfinished work is not committed; a place on one machine means nothing on another. The words are cut in two
// here so that this file does not hold them.
TEST(Files, HoldNoLooseEndsAndNoPlacesOfOneMachine) {
  std::vector<std::string> const forbidden = {"TO"
                                              "DO",
                                              "FIX"
                                              "ME",
                                              "/ho"
                                              "me/",
                                              "/ro"
                                              "ot/",
                                              "/wo"
                                              "rk/",
                                              "registry."
                                              "npmjs"};
  for (auto const& file : source_files()) {
    for (auto const& word : forbidden) {
      EXPECT_EQ(file.text.find(word), std::string::npos) << file.path << " holds " << word;
    }
  }
}

}  // namespace
}  // namespace inkflate::house
