// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace inkflate::monster_mash {

/// The numbers of a Monster Mash project, as the program of that name reads and writes it; docs/FORMATS.md.
inline constexpr int kWidthPx = 1000;
inline constexpr int kHeightPx = 800;
inline constexpr std::uint8_t kOutline = 0;   // in the outline's picture: drawn
inline constexpr std::uint8_t kClosing = 64;  // there too: open, where parts are joined
inline constexpr std::uint8_t kPaper = 255;   // there too: nothing
inline constexpr std::uint8_t kInside = 255;  // in the region's picture
inline constexpr int kMostRegions = 255;

}  // namespace inkflate::monster_mash
