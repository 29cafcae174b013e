// SPDX-License-Identifier: Apache-2.0
#include "io/png_rows.h"

#include <algorithm>
#include <cstdlib>

namespace inkflate::detail {
namespace {

std::uint8_t paeth(int left, int above, int corner) {
  int const guess = left + above - corner;
  int const to_left = std::abs(guess - left);
  int const to_above = std::abs(guess - above);
  int const to_corner = std::abs(guess - corner);
  if (to_left <= to_above && to_left <= to_corner) return static_cast<std::uint8_t>(left);
  return static_cast<std::uint8_t>(to_above <= to_corner ? above : corner);
}

/// Channel number i of the row, as stored: 1 to 16 bits.
std::uint32_t channel_value(std::span<std::uint8_t const> row, std::size_t i, int depth) {
  if (depth == 8) return row[i];
  if (depth == 16) return static_cast<std::uint32_t>(row[2 * i]) << 8U | row[2 * i + 1];
  std::size_t const bit = i * static_cast<std::size_t>(depth);
  int const shift = 8 - depth - static_cast<int>(bit % 8);
  return (row[bit / 8] >> shift) & ((1U << depth) - 1);
}

std::uint8_t to_byte(std::uint32_t value, int depth) {
  if (depth == 16) return static_cast<std::uint8_t>(value >> 8U);
  return static_cast<std::uint8_t>(value * 255 / ((1U << depth) - 1));
}

/// A pixel of any colour type but Palette.
Colour direct_colour(PngHeader const& header, std::array<std::uint32_t, 4> const& v) {
  auto const byte = [&](std::size_t i) { return to_byte(v[i], header.depth); };
  auto const& clear = header.transparent;
  switch (header.colour) {
    case PngColour::Grey: {
      bool const is_clear = clear && v[0] == (*clear)[0];
      return {byte(0), byte(0), byte(0), static_cast<std::uint8_t>(is_clear ? 0 : 255)};
    }
    case PngColour::Rgb: {
      bool const is_clear =
          clear && v[0] == (*clear)[0] && v[1] == (*clear)[1] && v[2] == (*clear)[2];
      return {byte(0), byte(1), byte(2), static_cast<std::uint8_t>(is_clear ? 0 : 255)};
    }
    case PngColour::GreyAlpha:
      return {byte(0), byte(0), byte(0), byte(1)};
    case PngColour::RgbAlpha:
    case PngColour::Palette:
      break;
  }
  return {byte(0), byte(1), byte(2), byte(3)};
}

}  // namespace

int PngHeader::channels() const {
  switch (colour) {
    case PngColour::Grey:
    case PngColour::Palette:
      return 1;
    case PngColour::GreyAlpha:
      return 2;
    case PngColour::Rgb:
      return 3;
    case PngColour::RgbAlpha:
      break;
  }
  return 4;
}

std::size_t PngHeader::row_bytes(int pixels) const {
  return (static_cast<std::size_t>(pixels) * static_cast<std::size_t>(channels() * depth) + 7) / 8;
}

bool unfilter(int filter, std::span<std::uint8_t> row, std::span<std::uint8_t const> above,
              std::size_t pixel_bytes) {
  if (filter < 0 || filter > 4) return false;
  for (std::size_t i = 0; i < row.size() && filter != 0; ++i) {
    int const left = i >= pixel_bytes ? row[i - pixel_bytes] : 0;
    int const corner = i >= pixel_bytes ? above[i - pixel_bytes] : 0;
    int guess = 0;
    if (filter == 1) guess = left;
    if (filter == 2) guess = above[i];
    if (filter == 3) guess = (left + above[i]) / 2;
    if (filter == 4) guess = paeth(left, above[i], corner);
    row[i] = static_cast<std::uint8_t>(row[i] + guess);
  }
  return true;
}

bool unpack_row(PngHeader const& header, std::span<std::uint8_t const> row, int count, int x0,
                int step, int y, Picture& picture) {
  auto const channels = static_cast<std::size_t>(header.channels());
  std::array<std::uint32_t, 4> values{};
  for (int i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < channels; ++c) {
      values[c] = channel_value(row, static_cast<std::size_t>(i) * channels + c, header.depth);
    }
    auto& pixel = picture.at(x0 + i * step, y);
    if (header.colour != PngColour::Palette) {
      pixel = direct_colour(header, values);
    } else if (values[0] < header.palette.size()) {
      pixel = header.palette[values[0]];
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace inkflate::detail
