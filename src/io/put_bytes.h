// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace inkflate {

/// Appends to bytes, as binary model files want it: the lowest byte of a number first.

inline void put_little_endian16(std::vector<std::byte>& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::byte>(value));
  bytes.push_back(static_cast<std::byte>(value >> 8U));
}
inline void put_little_endian32(std::vector<std::byte>& bytes, std::uint32_t value) {
  put_little_endian16(bytes, value);
  put_little_endian16(bytes, value >> 16U);
}
/// The number rounded to single precision. -0 becomes 0, so that equal models are equal files.
inline void put_float32(std::vector<std::byte>& bytes, double number) {
  float const rounded = static_cast<float>(number) + 0.0F;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &rounded, sizeof bits);
  put_little_endian32(bytes, bits);
}
inline void put_text(std::vector<std::byte>& bytes, std::string_view text) {
  for (char const sign : text) bytes.push_back(static_cast<std::byte>(sign));
}

inline std::vector<std::byte> bytes_of(std::string_view text) {
  std::vector<std::byte> bytes;
  put_text(bytes, text);
  return bytes;
}

}  // namespace inkflate
