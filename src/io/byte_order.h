// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace inkflate {

/// Numbers in bytes; the caller has checked that the bytes are there.
inline std::uint32_t big_endian16(std::span<std::byte const> bytes) {
  return static_cast<std::uint32_t>(bytes[0]) << 8U | static_cast<std::uint32_t>(bytes[1]);
}
inline std::uint32_t big_endian32(std::span<std::byte const> bytes) {
  return big_endian16(bytes) << 16U | big_endian16(bytes.subspan(2));
}
inline std::uint32_t little_endian16(std::span<std::byte const> bytes) {
  return static_cast<std::uint32_t>(bytes[1]) << 8U | static_cast<std::uint32_t>(bytes[0]);
}
inline std::uint32_t little_endian32(std::span<std::byte const> bytes) {
  return little_endian16(bytes.subspan(2)) << 16U | little_endian16(bytes);
}

}  // namespace inkflate
