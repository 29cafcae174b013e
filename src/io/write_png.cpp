// SPDX-License-Identifier: Apache-2.0
#include "io/write_png.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>

#include "base/check.h"
#include "io/png_crc.h"
#include "io/stb.h"

namespace inkflate {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr long long kMostPixels = 64'000'000;

void put32(std::vector<std::byte>& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::byte>(value >> shift));
}

void put_text(std::vector<std::byte>& bytes, std::string_view text) {
  for (char const sign : text) bytes.push_back(static_cast<std::byte>(sign));
}

void put_chunk(std::vector<std::byte>& file, std::string_view type,
               std::span<std::byte const> data) {
  put32(file, static_cast<std::uint32_t>(data.size()));
  auto const start = file.size();
  put_text(file, type);
  file.insert(file.end(), data.begin(), data.end());
  put32(file, png_crc(std::span(file).subspan(start)));
}

/// Row filters 0 to 2 (none, left, above) as pictures of flat areas and lines want them.
void filter_row(int filter, std::span<std::uint8_t const> row, std::span<std::uint8_t const> above,
                std::size_t pixel_bytes, std::span<std::uint8_t> filtered) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    int guess = 0;
    if (filter == 1 && i >= pixel_bytes) guess = row[i - pixel_bytes];
    if (filter == 2) guess = above[i];
    filtered[i] = static_cast<std::uint8_t>(row[i] - guess);
  }
}

/// The specification's rule of thumb: the row with the smallest sum of differences packs best (section 12.8).
long long roughness(std::span<std::uint8_t const> filtered) {
  long long sum = 0;
  for (auto const byte : filtered) sum += std::abs(static_cast<std::int8_t>(byte));
  return sum;
}

std::vector<std::byte> filtered_rows(std::span<std::uint8_t const> pixels, std::size_t row_bytes,
                                     std::size_t pixel_bytes) {
  std::vector<std::byte> result;
  result.reserve(pixels.size() + pixels.size() / row_bytes);
  std::vector<std::uint8_t> const zeros(row_bytes);
  std::array<std::vector<std::uint8_t>, 3> tries;
  std::span<std::uint8_t const> above = zeros;
  for (std::size_t start = 0; start < pixels.size(); start += row_bytes) {
    auto const row = pixels.subspan(start, row_bytes);
    // Flat areas and straight edges repeat whole rows; nothing packs better than no difference at all.
    if (std::equal(row.begin(), row.end(), above.begin())) {
      result.push_back(std::byte{2});
      result.resize(result.size() + row_bytes);
      above = row;
      continue;
    }
    int best = 0;
    for (int filter = 0; filter < 3; ++filter) {
      auto& filtered = tries[static_cast<std::size_t>(filter)];
      filtered.resize(row_bytes);
      filter_row(filter, row, above, pixel_bytes, filtered);
      if (roughness(filtered) < roughness(tries[static_cast<std::size_t>(best)])) best = filter;
    }
    result.push_back(static_cast<std::byte>(best));
    auto const bytes = std::as_bytes(std::span(tries[static_cast<std::size_t>(best)]));
    result.insert(result.end(), bytes.begin(), bytes.end());
    above = row;
  }
  return result;
}

std::vector<std::byte> write(std::span<std::uint8_t const> pixels, int width, int height,
                             std::size_t pixel_bytes, std::byte colour_type) {
  CHECK(width > 0 && height > 0 && static_cast<long long>(width) * height <= kMostPixels,
        "a PNG has 1 to 64 000 000 pixels");
  std::vector<std::byte> header;
  put32(header, static_cast<std::uint32_t>(width));
  put32(header, static_cast<std::uint32_t>(height));
  for (auto const byte : {std::byte{8}, colour_type, std::byte{0}, std::byte{0}, std::byte{0}}) {
    header.push_back(byte);
  }
  std::vector<std::byte> file;
  put_text(file, kSignature);
  put_chunk(file, "IHDR", header);
  auto const row_bytes = static_cast<std::size_t>(width) * pixel_bytes;
  put_chunk(file, "IDAT", detail::compress_zlib(filtered_rows(pixels, row_bytes, pixel_bytes)));
  put_chunk(file, "IEND", {});
  return file;
}

}  // namespace

std::vector<std::byte> write_png(Picture const& picture) {
  bool const is_opaque = std::all_of(picture.values.begin(), picture.values.end(),
                                     [](Colour colour) { return colour.a == 255; });
  if (is_opaque) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(picture.values.size() * 3);
    for (auto const colour : picture.values) rgb.insert(rgb.end(), {colour.r, colour.g, colour.b});
    return write(rgb, picture.width, picture.height, 3, std::byte{2});
  }
  static_assert(sizeof(Colour) == 4, "a colour is its four bytes in RGBA order");
  auto const* const first = reinterpret_cast<std::uint8_t const*>(picture.values.data());
  return write({first, picture.values.size() * 4}, picture.width, picture.height, 4, std::byte{6});
}

std::vector<std::byte> write_png(Mask const& mask) {
  return write(mask.values, mask.width, mask.height, 1, std::byte{0});
}

}  // namespace inkflate
