// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "image/grid2.h"

namespace inkflate::detail {

enum class PngColour { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, RgbAlpha = 6 };

/// What the chunks before the pixels say; already checked.
struct PngHeader {
  int width = 0;
  int height = 0;
  int depth = 8;  // bits per channel
  PngColour colour = PngColour::RgbAlpha;
  bool is_interlaced = false;
  std::vector<Colour> palette;  // with alpha from tRNS
  std::optional<std::array<std::uint32_t, 3>>
      transparent;  // this grey (first only) or RGB value is clear

  int channels() const;
  /// Bytes of a row of this many pixels, without its filter byte.
  std::size_t row_bytes(int pixels) const;
};

/// Undoes a row's filter (PNG specification, section 9). above: the row before, zeros at the first; of equal size.
/// False: no such filter.
[[nodiscard]] bool unfilter(int filter, std::span<std::uint8_t> row,
                            std::span<std::uint8_t const> above, std::size_t pixel_bytes);

/// Writes a row's pixels to (x0 + i * step, y). False: a palette index that the palette does not have.
[[nodiscard]] bool unpack_row(PngHeader const& header, std::span<std::uint8_t const> row, int count,
                              int x0, int step, int y, Picture& picture);

}  // namespace inkflate::detail
