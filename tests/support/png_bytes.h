// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "io/png_crc.h"

namespace inkflate::test {

using Bytes = std::vector<std::byte>;

/// How the frame header of a baseline JPEG starts: marker and length for three components.
inline Bytes const kFrameMarker = {std::byte{0xff}, std::byte{0xc0}, std::byte{0}, std::byte{17}};

inline void put(Bytes& bytes, std::initializer_list<int> values) {
  for (int const value : values) bytes.push_back(static_cast<std::byte>(value));
}
inline void put(Bytes& bytes, Bytes const& more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}
inline void put32(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::byte>(value >> shift));
}

inline Bytes chunk(std::string_view type, Bytes const& data) {
  Bytes bytes;
  put32(bytes, static_cast<std::uint32_t>(data.size()));
  auto const start = bytes.size();
  for (char const sign : type) bytes.push_back(static_cast<std::byte>(sign));
  put(bytes, data);
  put32(bytes, png_crc(std::span(bytes).subspan(start)));
  return bytes;
}

/// A zlib stream of one stored block.
inline Bytes stored_zlib(Bytes const& data) {
  Bytes bytes;
  auto const size = static_cast<int>(data.size());
  put(bytes, {0x78, 0x01, 1, size & 255, size >> 8, ~size & 255, (~size >> 8) & 255});
  put(bytes, data);
  std::uint32_t low = 1;
  std::uint32_t high = 0;
  for (auto const byte : data) {
    low = (low + static_cast<std::uint32_t>(byte)) % 65521;
    high = (high + low) % 65521;
  }
  put32(bytes, high << 16U | low);
  return bytes;
}

inline Bytes png_header(int width, int height, int depth, int colour, int interlace = 0) {
  Bytes data;
  put32(data, static_cast<std::uint32_t>(width));
  put32(data, static_cast<std::uint32_t>(height));
  put(data, {depth, colour, 0, 0, interlace});
  return chunk("IHDR", data);
}

/// A PNG from its chunks between the header and the end.
inline Bytes png(Bytes const& header, Bytes const& chunks) {
  Bytes bytes;
  put(bytes, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
  put(bytes, header);
  put(bytes, chunks);
  put(bytes, chunk("IEND", {}));
  return bytes;
}

/// A PNG from its rows as they lie in the file, each with its filter byte.
inline Bytes png_of_rows(Bytes const& header, Bytes const& rows) {
  return png(header, chunk("IDAT", stored_zlib(rows)));
}

}  // namespace inkflate::test
