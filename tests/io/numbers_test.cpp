// SPDX-License-Identifier: Apache-2.0
#include "io/numbers.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "base/rng.h"

namespace inkflate {
namespace {

double number_in(std::string_view text) { return take_number(text).value_or(-12345); }

TEST(Numbers, AgreeWithTheLibraryOnEveryForm) {
  for (char const* text :
       {"0", "-0", "7", "+7", "-7.25", ".5", "5.", "1e3", "1E-3", "2.5e+10", "123456789012345678",
        "12345678901234567890123", "1e22", "1e23", "9.95e-320", "0.1", "1.7976931348623157e308",
        "4.9e-324", "000000000000000000000.25"}) {
    EXPECT_EQ(number_in(text), std::strtod(text, nullptr)) << text;
  }
}

TEST(Numbers, StopWhereTheNumberEnds) {
  std::string_view text = "1.5.25-3e2em";
  EXPECT_EQ(take_number(text), 1.5);
  EXPECT_EQ(take_number(text), .25);
  EXPECT_EQ(take_number(text), -300);
  EXPECT_EQ(text, "em");
  EXPECT_EQ(take_number(text), std::nullopt);
  EXPECT_EQ(text, "em");
}

TEST(Numbers, WordsAreNotNumbers) {
  for (std::string_view text : {"nan", "inf", "-", "+.", "e5", "", "0x10"}) {
    bool const is_zero = text == "0x10";  // the zero in front of the x
    EXPECT_EQ(take_number(text), is_zero ? std::optional(0.0) : std::nullopt);
  }
}

TEST(Numbers, HugeExponentsAreInfiniteOrZero) {
  EXPECT_TRUE(std::isinf(number_in("1e400")));
  EXPECT_TRUE(std::isinf(number_in("-1e99999999999999999999")));
  EXPECT_EQ(number_in("1e-99999999999999999999"), 0);
  EXPECT_EQ(number_in("0e99999"), 0);
  EXPECT_EQ(number_in(std::string(5000, '9')), HUGE_VAL);
  EXPECT_NEAR(number_in("0." + std::string(5000, '3')), 1.0 / 3, 1e-16);
}

TEST(Numbers, WrittenNumbersReadBackExactly) {
  Rng rng(4);
  for (int i = 0; i < 20000; ++i) {
    std::uint64_t const bits = rng.bits();
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    if (i % 2 == 0) number = std::round(rng.uniform(-1e5, 1e5)) / 1000;
    if (!std::isfinite(number)) continue;
    std::string text;
    append_number(text, number);
    ASSERT_EQ(number_in(text), number) << text;
    ASSERT_EQ(std::strtod(text.c_str(), nullptr), number) << text;
  }
}

TEST(Numbers, ShortNumbersStayShort) {
  std::string text;
  for (double const number : {0.1, 12.0, -3.75, 1e6, 0.30000000000000004}) {
    append_number(text, number);
    text += ' ';
  }
  append_rounded(text, 2.00049);
  EXPECT_EQ(text, "0.1 12 -3.75 1000000 0.30000000000000004 2");
}

TEST(Numbers, DoNotDependOnTheLocale) {
  for (char const* name : {"de_DE.UTF-8", "cs_CZ.UTF-8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_NUMERIC, name) != nullptr) break;  // else this shows the same in "C"
  }
  std::string text;
  append_number(text, 0.25);
  EXPECT_EQ(text, "0.25");
  EXPECT_EQ(number_in("1.5e-30"), 1.5e-30);
  std::setlocale(LC_NUMERIC, "C");
}

TEST(Numbers, IndicesFitAnInt) {
  std::string_view text = "2147483647 2147483648";
  EXPECT_EQ(take_index(text), 2147483647);
  skip_separator(text, Separator::Blank);
  EXPECT_EQ(take_index(text), std::nullopt);
}

}  // namespace
}  // namespace inkflate
