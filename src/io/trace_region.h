// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "image/grid2.h"
#include "model/drawing.h"

namespace inkflate {

/// The pixels of a picture of lines.
inline constexpr std::uint8_t kNoLine = 0;
inline constexpr std::uint8_t kInkLine = 1;
inline constexpr std::uint8_t kHelpLine = 2;

/// A closed area with its holes, as outlines: the outer one first.
using TracedRegion = std::vector<Outline>;

/// The boundaries of a region's areas as smooth outlines, each cut where the ink's kind changes.
///
/// in      region: 0 outside
///         lines: what was drawn along its boundary, of the same size. A boundary pixel is of the kind that it has here, else
///         of one next to it, ink before help line; where there is nothing it counts as ink
/// out     areas of at least 16 px (holes likewise) in the order of their first pixels. Outlines run through the centres of the boundary's pixels; no outline
///         of an area crosses or touches itself or another one of that area
/// errors  TooLarge (more than 1000 areas)
/// cost    O(pixels + boundary log boundary)
Result<std::vector<TracedRegion>> trace_region(Mask const& region, Mask const& lines);

}  // namespace inkflate
