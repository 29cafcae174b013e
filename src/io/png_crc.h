// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace inkflate {

/// The checksum of a PNG chunk: CRC-32 with the polynomial of ISO 3309 (PNG specification, annex D).
inline std::uint32_t png_crc(std::span<std::byte const> bytes) {
  static constexpr auto table_of_bytes = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t value = n;
      for (int bit = 0; bit < 8; ++bit) {
        value = (value & 1U) != 0 ? 0xedb88320U ^ (value >> 1U) : value >> 1U;
      }
      table[n] = value;
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffU;
  for (auto const byte : bytes) {
    crc = table_of_bytes[(crc ^ static_cast<std::uint32_t>(byte)) & 0xffU] ^ (crc >> 8U);
  }
  return crc ^ 0xffffffffU;
}

}  // namespace inkflate
