// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "model/drawing.h"

namespace inkflate {

/// Something in a file that was not taken over.
struct SvgWarning {
  std::string reason;         // "a coordinate beyond 1e6 px"
  int count = 0;              // of elements
  long long first_byte = -1;  // of the first of them

  friend bool operator==(SvgWarning const&, SvgWarning const&) = default;
};

struct SvgReading {
  Drawing drawing;
  std::vector<SvgWarning> warnings;  // in the order in which they first came up
};

/// Reads an SVG as a sketch: every subpath of what it draws becomes a stroke.
///
/// in      bytes: UTF-8; all of SVG 1.1's shapes, g, use, symbol, nested svg, transforms, units, inline style and simple style
///         sheets. A file by write_svg gives back its Drawing exactly instead.
/// out     strokes in drawing order, curves sampled to 0.1 px, a closed subpath's first sample repeated at its end; what is
///         filled but not stroked comes as its outline. Help lines are dashed, or have a class with "help", or lie in a group
///         whose name starts with "help". Groups are the top-level groups, other than those of help lines; their
///         attributes data-fill (a colour) and data-thickness (0.1 .. 32) are what the layer shall look like.
///         Not drawn: text, pictures, clips, masks, markers, patterns, anything outside the file.
/// errors  BadInput (index: the byte), TooLarge, Unsupported (UTF-16, entities)
/// cost    O(bytes + samples); what use elements copy is limited, see docs/LIMITS.md
Result<SvgReading> read_svg_with_warnings(std::span<std::byte const> bytes);

/// The drawing alone.
Result<Drawing> read_svg(std::span<std::byte const> bytes);

}  // namespace inkflate
