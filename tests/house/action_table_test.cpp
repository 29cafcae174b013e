// SPDX-License-Identifier: Apache-2.0
#include "support/action_table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "house/source_files.h"

namespace inkflate::house {
namespace {

TEST(ActionTable, IsTheOneInTheDocuments) {
  auto const files = source_files();
  auto const page = std::find_if(files.begin(), files.end(), [](SourceFile const& file) {
    return file.path == "docs/ACTIONS.md";
  });
  ASSERT_NE(page, files.end());
  EXPECT_EQ(page->text, support::action_table())
      << "print it anew: build/dev/tests/action_table > docs/ACTIONS.md";
}

}  // namespace
}  // namespace inkflate::house
