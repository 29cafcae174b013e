// SPDX-License-Identifier: Apache-2.0
#include "support/action_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace inkflate::house {
namespace {

std::string text_of(std::string const& path) {
  std::ifstream stream(INKFLATE_SOURCE_DIR "/" + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ActionTable, IsTheOneInTheDocuments) {
  EXPECT_EQ(text_of("docs/ACTIONS.md"), support::action_table())
      << "print it anew: build/dev/tests/action_table > docs/ACTIONS.md";
}

TEST(ActionTable, NamesAreThoseOfTheWebStudio) {
  std::string const path = "apps/web/src/protocol/actions.generated.ts";
  EXPECT_EQ(text_of(path), support::action_names())
      << "print it anew: build/dev/tests/action_names > " << path;
}

}  // namespace
}  // namespace inkflate::house
