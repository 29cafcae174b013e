// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace inkflate {

/// The nearest byte of a value in 0 .. 255. Not by lround, which is a call for each pixel.
inline std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(value + 0.5);  // NOLINT(bugprone-incorrect-roundings): >= 0
}

}  // namespace inkflate
