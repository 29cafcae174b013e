// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/colour.h"

namespace inkflate {

/// The colours of a drawing wherever we show one.
namespace palette {

inline constexpr Colour kPaper = {0xfb, 0xf8, 0xf2};
inline constexpr Colour kInk = {0x22, 0x24, 0x2b};
inline constexpr Colour kSkin = {0xfd, 0xf6, 0xe9};       // of a model's layer without a colour
inline constexpr Colour kShape = {0xff, 0xb3, 0x7a, 89};  // pale apricot, 35 %
inline constexpr Colour kClosing = {0xe8, 0x60, 0x4c};    // dotted
inline constexpr Colour kHelpLine = {0x1f, 0x8a, 0x7d};   // dashed
inline constexpr Colour kSelection = {0x2f, 0x6d, 0xf6};  // always with a halo
inline constexpr Colour kHalo = {0xff, 0xff, 0xff};
inline constexpr Colour kGrid = {0x6b, 0x55, 0x2e, 16};
inline constexpr Colour kStrongGrid = {0x6b, 0x55, 0x2e, 32};

inline constexpr std::uint8_t kFaintAlpha = 64;  // 25 %: hidden ink, ink of before

}  // namespace palette

/// The colour as opaque as it was, times a share of 0 .. 1.
inline constexpr Colour faded(Colour colour, double share) {
  colour.a = static_cast<std::uint8_t>(colour.a * share + 0.5);
  return colour;
}

}  // namespace inkflate
