// SPDX-License-Identifier: Apache-2.0
#include "support/golden.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace inkflate {
namespace {

// Nothing here shall be approved by the way.
class Golden : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("INKFLATE_UPDATE_GOLDEN") != nullptr) GTEST_SKIP() << "pictures are approved";
  }
};

TEST_F(Golden, APictureThatNobodyApprovedDoesNotMatch) {
  auto const result = matches_golden(Picture(4, 3, {1, 2, 3}), "nobody_approved_this");
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find("missing"), std::string::npos);
  std::filesystem::remove(std::string(INKFLATE_SOURCE_DIR) +
                          "/build/golden/nobody_approved_this.png");
}

TEST_F(Golden, AFewPixelsMayDifferAndEachALittle) {
  Picture dots(100, 100, {255, 255, 255});
  for (int i = 0; i < 100; ++i) dots.at(i, i) = {0, 0, 0};
  EXPECT_TRUE(matches_golden(dots, "diagonal"));
  for (auto& value : dots.values) value.r = static_cast<std::uint8_t>(value.r ^ 8U);
  EXPECT_TRUE(matches_golden(dots, "diagonal"));
  for (int i = 0; i < 20; ++i) dots.at(i, 50) = {0, 0, 0};
  EXPECT_TRUE(matches_golden(dots, "diagonal"));
  for (int i = 20; i < 23; ++i) dots.at(i, 50) = {0, 0, 0};
  EXPECT_FALSE(matches_golden(dots, "diagonal"));
  EXPECT_TRUE(std::filesystem::remove(std::string(INKFLATE_SOURCE_DIR) +
                                      "/build/golden/diagonal-difference.png"));
}

}  // namespace
}  // namespace inkflate
