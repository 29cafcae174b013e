// SPDX-License-Identifier: Apache-2.0
#include "io/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "base/check.h"

namespace inkflate {
namespace {

constexpr int kKeptDigits = 19;  // as many as always fit in 64 bits
constexpr int kExponentLimit = 100'000;

struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;  // value = digits * 10^exponent
};

std::size_t count_digits(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - at;
}

// Significant digits beyond the kept ones only move the exponent.
void take_digits(std::string_view digits, int exponent_step, int& kept, Decimal& number) {
  for (char const c : digits) {
    if (kept < kKeptDigits) {
      number.digits = number.digits * 10 + static_cast<std::uint64_t>(c - '0');
      if (number.digits > 0) ++kept;
      number.exponent += exponent_step;
    } else if (number.exponent < kExponentLimit) {
      number.exponent += exponent_step + 1;
    }
  }
}

int exponent_value(std::string_view digits) {
  int value = 0;
  for (char const c : digits) value = std::min(value * 10 + (c - '0'), kExponentLimit);
  return value;
}

double nearest_double(Decimal number) {
  constexpr std::array<double, 23> powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                             1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                             1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  // Both operands are exact here, so one operation rounds correctly (Clinger 1990).
  auto const magnitude = static_cast<std::size_t>(std::abs(number.exponent));
  if (number.digits <= (std::uint64_t{1} << 53U) && magnitude < powers.size()) {
    auto const digits = static_cast<double>(number.digits);
    return number.exponent < 0 ? digits / powers[magnitude] : digits * powers[magnitude];
  }
  // Without a decimal point the library's answer does not depend on the locale.
  std::array<char, 48> token = {};
  std::snprintf(token.data(), token.size(), "%llue%d",
                static_cast<unsigned long long>(number.digits), number.exponent);
  return std::strtod(token.data(), nullptr);
}

}  // namespace

std::string lower_ascii(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = lower_ascii(c);
  return lower;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

void skip_separator(std::string_view& text, Separator separator) {
  bool comma_left = separator == Separator::Comma;
  while (!text.empty() && (is_blank(text.front()) || (comma_left && text.front() == ','))) {
    if (text.front() == ',') comma_left = false;
    text.remove_prefix(1);
  }
}

std::optional<double> take_number(std::string_view& text) {
  std::size_t at = 0;
  bool const is_negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) ++at;
  auto const whole = count_digits(text, at);
  std::size_t const point = at + whole;
  bool const has_point = point < text.size() && text[point] == '.';
  auto const fraction = has_point ? count_digits(text, point + 1) : 0;
  if (whole + fraction == 0) return std::nullopt;
  Decimal number;
  int kept = 0;
  take_digits(text.substr(at, whole), 0, kept, number);
  at += whole;
  if (has_point) {
    take_digits(text.substr(at + 1, fraction), -1, kept, number);
    at += 1 + fraction;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t digits_at = at + 1;
    bool const has_sign =
        digits_at < text.size() && (text[digits_at] == '-' || text[digits_at] == '+');
    if (has_sign) ++digits_at;
    auto const size = count_digits(text, digits_at);
    if (size > 0) {  // else the letter belongs to what follows, as in "2em"
      int const exponent = exponent_value(text.substr(digits_at, size));
      number.exponent += text[digits_at - 1] == '-' ? -exponent : exponent;
      at = digits_at + size;
    }
  }
  text.remove_prefix(at);
  double const value = nearest_double(number);
  return is_negative ? -value : value;
}

std::optional<int> take_index(std::string_view& text) {
  auto const size = count_digits(text, 0);
  if (size == 0 || size > 10) return std::nullopt;
  std::int64_t value = 0;
  for (char const c : text.substr(0, size)) value = value * 10 + (c - '0');
  if (value > std::numeric_limits<int>::max()) return std::nullopt;
  text.remove_prefix(size);
  return static_cast<int>(value);
}

void append_number(std::string& text, double number) {
  CHECK(std::isfinite(number), "only finite numbers are written");
  std::array<char, 40> token = {};
  std::string clean;
  for (int digits = 15; digits <= 17; ++digits) {
    int const size = std::snprintf(token.data(), token.size(), "%.*g", digits, number);
    clean.clear();
    // Whatever the locale's decimal point is, in one byte or more, it becomes one '.'.
    for (char const c : std::string_view(token.data(), static_cast<std::size_t>(size))) {
      bool const is_ours = is_digit(c) || c == '-' || c == '+' || c == 'e';
      if (is_ours) clean += c;
      if (!is_ours && (clean.empty() || clean.back() != '.')) clean += '.';
    }
    std::string_view rest = clean;
    if (take_number(rest) == number) break;
  }
  text += clean;
}

std::string hex_digits(std::uint64_t number) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) {
    text += "0123456789abcdef"[number >> static_cast<unsigned>(shift) & 15U];
  }
  return text;
}

void append_rounded(std::string& text, double number) {
  append_number(text, std::abs(number) < 1e9 ? std::round(number * 1000) / 1000 : number);
}

}  // namespace inkflate
