// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/draw_list.h"

namespace inkflate::web {

/// Red in the lowest byte, alpha in the highest.
std::uint32_t packed(Colour colour);

/// Appends a draw list as src/protocol/draw-list.ts reads it: items one after another, u32 and f32, the lowest byte first.
///
///   fill     0, colour, contours; for each: points, x, y, ...
///   stroke   1, colour, points, widths, dashes (counts), least, most (px), x, y, ..., widths, dashes
///   dots     2, colour, count, diameter, x, y, ...
///   picture  3, opacity, width, height, a, b, c, d, e, f, then its pixels: red, green, blue, alpha
void write_draw_list(DrawList const& list, std::vector<std::byte>& bytes);

}  // namespace inkflate::web
