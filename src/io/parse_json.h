// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "base/result.h"

namespace inkflate {

/// What JSON may ask for; see docs/LIMITS.md.
struct JsonLimits {
  static constexpr long long kBytes = 128LL << 20U;
  static constexpr int kDepth = 64;
  static constexpr long long kValues = 8'000'000;
};

/// TooLarge if the text goes beyond JsonLimits, by a look at its brackets and commas. Says nothing about other faults.
Result<bool> check_json_limits(std::string_view text);

/// Parses JSON; the limits are checked before memory is taken.
///
/// errors  TooLarge; BadInput (no JSON: numbers beyond the range of doubles count as such)
/// cost    O(bytes)
Result<nlohmann::json> parse_json(std::string_view text);

}  // namespace inkflate
