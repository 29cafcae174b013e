// SPDX-License-Identifier: Apache-2.0
#include "io/base64.h"

#include <gtest/gtest.h>

#include "io/bytes.h"

namespace inkflate {
namespace {

std::string decoded(std::string_view text) {
  auto const bytes = parse_base64(text);
  if (!bytes) return "refused";
  std::string result;
  for (auto const byte : *bytes) result += static_cast<char>(byte);
  return result;
}

TEST(Base64, IsThatOfTheStandard) {
  struct Case {
    std::string_view bytes;
    std::string_view text;
  };
  for (auto const& [bytes, text] :
       {Case{"", ""}, Case{"f", "Zg=="}, Case{"fo", "Zm8="}, Case{"foo", "Zm9v"},
        Case{"foob", "Zm9vYg=="}, Case{"fooba", "Zm9vYmE="}, Case{"foobar", "Zm9vYmFy"},
        Case{"\xfb\xff\xbf", "+/+/"}}) {
    EXPECT_EQ(base64_of(as_bytes(bytes)), text);
    EXPECT_EQ(decoded(text), bytes);
  }
}

TEST(Base64, WhatNothingWroteIsRefused) {
  for (auto const* const text : {"Z", "Zg", "Zg=", "=", "==", "===", "====", "Zg==Zg==", "Z===",
                                 "Zh==", "Zm9=", "Zm 9", "Zm-_", "Zm9v\n", "=m9v", "Z=9v"}) {
    EXPECT_EQ(decoded(text), "refused") << text;
  }
}

}  // namespace
}  // namespace inkflate
