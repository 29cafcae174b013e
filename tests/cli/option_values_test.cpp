// SPDX-License-Identifier: Apache-2.0
#include "cli/option_values.h"

#include <gtest/gtest.h>

namespace inkflate::cli {
namespace {

TEST(OptionValues, NumberIsTheWholeText) {
  EXPECT_EQ(parse_number("12.5"), 12.5);
  EXPECT_EQ(parse_number("-3e2"), -300);
  for (auto const* text : {"", " 1", "1 ", "1px", "0x10", "nan", "inf", "1e999", "1,5"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(OptionValues, PointIsTwoNumbersAndAComma) {
  EXPECT_EQ(*parse_point("--inside", "-1,2.5"), (Vec2{-1, 2.5}));
  for (auto const* text : {"", "1", "1,", ",2", "1,2,3", "1;2", "1, 2"}) {
    EXPECT_FALSE(parse_point("--inside", text).has_value()) << text;
  }
}

}  // namespace
}  // namespace inkflate::cli
