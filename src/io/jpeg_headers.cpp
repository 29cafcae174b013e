// SPDX-License-Identifier: Apache-2.0
#include "io/jpeg_headers.h"

#include <cstdint>
#include <cstring>
#include <optional>

#include "io/byte_order.h"

namespace inkflate::detail {
namespace {

// Markers of ITU T.81, table B.1.
constexpr unsigned kHuffmanTables = 0xc4;
constexpr unsigned kStartOfImage = 0xd8;
constexpr unsigned kEndOfImage = 0xd9;
constexpr unsigned kStartOfScan = 0xda;
constexpr unsigned kApp1 = 0xe1;

constexpr std::uint32_t kOrientationTag = 0x0112;

Error cut_off(std::size_t size) {
  return {ErrorCode::BadInput,
          "the JPEG is cut off after " + std::to_string(size) + " bytes: copy or download it again",
          static_cast<long long>(size)};
}

Error damaged(char const* what, std::size_t offset) {
  return {ErrorCode::BadInput,
          "damaged JPEG: " + std::string(what) + " at byte " + std::to_string(offset),
          static_cast<long long>(offset)};
}

unsigned byte_at(std::span<std::byte const> file, std::size_t i) {
  return static_cast<unsigned>(file[i]);
}

bool is_restart(unsigned marker) { return marker >= 0xd0 && marker <= 0xd7; }
bool is_frame(unsigned marker) {
  // C4, C8 and CC are tables and a reserved one.
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

/// The first marker at or after the offset that ends a scan's coded data; the file's size when there is none.
std::size_t end_of_scan(std::span<std::byte const> file, std::size_t offset) {
  for (; offset + 1 < file.size(); ++offset) {
    if (byte_at(file, offset) != 0xff) continue;
    auto const next = byte_at(file, offset + 1);
    if (next != 0 && next != 0xff && !is_restart(next)) return offset;
  }
  return file.size();
}

std::optional<Error> read_frame(unsigned marker, std::span<std::byte const> payload,
                                std::size_t offset, JpegHeaders& headers) {
  if (marker > 0xc2 || payload.size() < 6 || payload[0] != std::byte{8}) {
    return Error{ErrorCode::Unsupported,
                 "this kind of JPEG (lossless, arithmetic or 12 bit) is not read: save it as a PNG",
                 static_cast<long long>(offset)};
  }
  if (headers.components != 0) return damaged("a second frame", offset);
  headers.is_progressive = marker == 0xc2;
  headers.height = static_cast<int>(big_endian16(payload.subspan(1)));
  headers.width = static_cast<int>(big_endian16(payload.subspan(3)));
  headers.components = static_cast<int>(payload[5]);
  return std::nullopt;
}

/// Whether the segment's tables are whole and no table has more than 256 codes: the decoder trusts them.
bool has_sound_tables(std::span<std::byte const> payload) {
  constexpr std::size_t head_bytes =
      17;  // the table's name, then how many codes have 1, 2, .. 16 bits
  while (!payload.empty()) {
    if (payload.size() < head_bytes) return false;
    std::size_t codes = 0;
    for (std::size_t i = 1; i < head_bytes; ++i) codes += static_cast<std::size_t>(payload[i]);
    if (codes > 256 || payload.size() - head_bytes < codes) return false;
    payload = payload.subspan(head_bytes + codes);
  }
  return true;
}

struct Cursor {
  std::size_t offset = 2;
  bool is_at_end = false;
};

/// Reads the marker at the cursor and what belongs to it.
std::optional<Error> read_marker(std::span<std::byte const> file, Cursor& cursor,
                                 JpegHeaders& headers) {
  auto& offset = cursor.offset;
  if (offset + 2 > file.size()) return cut_off(file.size());
  if (byte_at(file, offset) != 0xff) return damaged("no marker", offset);
  auto const marker = byte_at(file, offset + 1);
  if (marker == 0xff) {  // fill
    ++offset;
    return std::nullopt;
  }
  if (marker == kEndOfImage) {
    cursor.is_at_end = true;
    return std::nullopt;
  }
  if (offset + 4 > file.size()) return cut_off(file.size());
  auto const length = big_endian16(file.subspan(offset + 2));
  if (length < 2) return damaged("impossible segment length", offset);
  if (file.size() - offset - 2 < length) return cut_off(file.size());
  auto const payload = file.subspan(offset + 4, length - 2);
  if (is_frame(marker)) {
    if (auto error = read_frame(marker, payload, offset, headers)) return error;
  }
  if (marker == kHuffmanTables && !has_sound_tables(payload))
    return damaged("wrong tables", offset);
  if (marker == kApp1 && headers.orientation == Orientation::Upright) {
    headers.orientation = exif_orientation(payload);
  }
  offset += 2 + length;
  if (marker == kStartOfScan) {
    ++headers.scans;
    offset = end_of_scan(file, offset);
  }
  return std::nullopt;
}

}  // namespace

Result<JpegHeaders> read_jpeg_headers(std::span<std::byte const> file) {
  JpegHeaders headers;
  if (file.size() < 2) return cut_off(file.size());
  if (byte_at(file, 0) != 0xff || byte_at(file, 1) != kStartOfImage) return damaged("no start", 0);
  Cursor cursor;
  while (!cursor.is_at_end) {
    if (auto error = read_marker(file, cursor, headers)) return *error;
  }
  if (headers.components == 0 || headers.scans == 0) return damaged("no picture", cursor.offset);
  return headers;
}

Orientation exif_orientation(std::span<std::byte const> payload) {
  constexpr std::size_t prefix_bytes = 6;  // "Exif" and two zeros
  if (payload.size() < prefix_bytes + 8 || std::memcmp(payload.data(), "Exif\0\0", 6) != 0) {
    return Orientation::Upright;
  }
  auto const tiff = payload.subspan(prefix_bytes);
  bool const is_little = tiff[0] == std::byte{'I'};
  auto const number16 = [&](std::size_t at) {
    return is_little ? little_endian16(tiff.subspan(at)) : big_endian16(tiff.subspan(at));
  };
  std::size_t const directory =
      is_little ? little_endian32(tiff.subspan(4)) : big_endian32(tiff.subspan(4));
  if (directory + 2 > tiff.size()) return Orientation::Upright;
  std::size_t const count = number16(directory);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t const entry = directory + 2 + 12 * i;
    if (entry + 12 > tiff.size()) break;
    if (number16(entry) != kOrientationTag) continue;
    auto const value = number16(entry + 8);
    return value >= 1 && value <= 8 ? static_cast<Orientation>(value) : Orientation::Upright;
  }
  return Orientation::Upright;
}

}  // namespace inkflate::detail
