// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "geometry/affine.h"
#include "geometry/vec2.h"

namespace inkflate {

/// A length in CSS px: a number with px, mm, cm, in, pt, pc, em, ex, rem, % or no unit. Nothing where it is not one, or
/// not finite. No fonts are read: an em is 16 px.
std::optional<double> length_px(std::string_view text, double percent_base);

/// A layer's thickness: a number in kLeastThickness .. kLargestThickness and nothing else.
std::optional<double> parse_thickness(std::string_view text);

/// SVG's list of matrix, translate, scale, rotate, skewX and skewY. Nothing where it is damaged.
std::optional<Affine> parse_transform(std::string_view text);

/// A viewBox: the rectangle of user space that is shown.
struct ViewBox {
  Vec2 min;
  Vec2 size;  // both > 0
};
std::optional<ViewBox> parse_view_box(std::string_view text);

/// The map that shows the box in a viewport from (0, 0) to size_px, as preserveAspectRatio asks.
Affine fit_view_box(ViewBox const& box, Vec2 size_px, std::string_view preserve_aspect_ratio);

}  // namespace inkflate
