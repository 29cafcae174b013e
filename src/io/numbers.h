// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace inkflate {

/// Numbers in text files: the same in every locale.

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline char lower_ascii(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

std::string lower_ascii(std::string_view text);
std::string_view trimmed(std::string_view text);

/// Drops blanks at the front, and with Comma one comma among them, as SVG separates its numbers.
enum class Separator { Blank, Comma };
void skip_separator(std::string_view& text, Separator separator);

/// Takes a decimal number off the front of the text: sign, digits with an optional point, exponent. Nothing, and
/// the text unchanged, when none starts there. Correctly rounded for up to 19 significant digits; further digits
/// are cut off. Too large a number is infinite.
std::optional<double> take_number(std::string_view& text);

/// Takes an integer in 0 .. 2^31 - 1 off the front.
std::optional<int> take_index(std::string_view& text);

/// Appends the shortest decimal of up to 15 digits that reads back as the same number, else one of 16 or 17.
/// The number is finite.
void append_number(std::string& text, double number);

/// 16 digits of base 16, in small letters: how hashes are written.
std::string hex_digits(std::uint64_t number);

/// Appends the number rounded to three decimals: for what is only looked at.
void append_rounded(std::string& text, double number);

}  // namespace inkflate
