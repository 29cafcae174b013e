// SPDX-License-Identifier: Apache-2.0
#include "base/result.h"

#include <gtest/gtest.h>

namespace inkflate {
namespace {

TEST(Result, HoldsTheValueOrTheError) {
  Result<int> const good = 7;
  ASSERT_TRUE(good.has_value());
  EXPECT_EQ(*good, 7);
  Result<int> const bad = Error{ErrorCode::TooLarge, "too many strokes", 3};
  ASSERT_FALSE(bad.has_value());
  EXPECT_EQ(bad.error().index, 3);
  EXPECT_STREQ(error_code_name(bad.error().code), "too_large");
}

}  // namespace
}  // namespace inkflate
