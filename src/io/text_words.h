// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

#include "io/numbers.h"

namespace inkflate {

/// Takes a line off the front of the text, without its end.
inline std::string_view take_line(std::string_view& text) {
  auto const end = std::min(text.find('\n'), text.size());
  auto const line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/// Takes the next word off the front, and the blanks before it; empty at the end of the text.
inline std::string_view take_word(std::string_view& text) {
  std::size_t start = 0;
  while (start < text.size() && is_blank(text[start])) ++start;
  std::size_t end = start;
  while (end < text.size() && !is_blank(text[end])) ++end;
  auto const word = text.substr(start, end - start);
  text.remove_prefix(end);
  return word;
}

}  // namespace inkflate
