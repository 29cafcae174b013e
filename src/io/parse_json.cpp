// SPDX-License-Identifier: Apache-2.0
#include "io/parse_json.h"

#include <algorithm>
#include <string>

namespace inkflate {

Result<bool> check_json_limits(std::string_view text) {
  if (std::ssize(text) > JsonLimits::kBytes) {
    return Error{ErrorCode::TooLarge, "the JSON text has more than 128 MB"};
  }
  int depth = 0;
  int most_depth = 0;
  long long values = 1;
  bool is_in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char const c = text[i];
    if (c == '"') is_in_string = !is_in_string;
    if (is_in_string) {
      if (c == '\\') ++i;
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (c == '[' || c == '{' || c == ',' || c == ':') ++values;
    most_depth = std::max(most_depth, depth);
  }
  if (most_depth > JsonLimits::kDepth) {
    return Error{ErrorCode::TooLarge, "the JSON text is nested deeper than 64"};
  }
  if (values > JsonLimits::kValues) {
    return Error{ErrorCode::TooLarge, "the JSON text has more than 8 000 000 values"};
  }
  return true;
}

Result<nlohmann::json> parse_json(std::string_view text) {
  if (auto const limits = check_json_limits(text); !limits) return limits.error();
  auto parsed = nlohmann::json::parse(text, nullptr, false);
  if (parsed.is_discarded()) return Error{ErrorCode::BadInput, "the JSON text is damaged"};
  return parsed;
}

}  // namespace inkflate
