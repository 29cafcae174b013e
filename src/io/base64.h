// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace inkflate {

/// Bytes as text: four signs for three bytes, "=" where the last ones are missing. source: RFC 4648, section 4
std::string base64_of(std::span<std::byte const> bytes);

/// The bytes again. Nothing: not what base64_of would have written.
std::optional<std::vector<std::byte>> parse_base64(std::string_view text);

}  // namespace inkflate
