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

}  // namespace palette
}  // namespace inkflate
