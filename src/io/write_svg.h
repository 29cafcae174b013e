// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/drawing.h"

namespace inkflate {

/// The drawing as an SVG that any program shows and that read_svg gives back exactly: read_svg(write_svg(d)) == d.
///
/// in      numbers finite, coordinates within 1e6, indices in range; each outline has pieces that join; names in UTF-8 without
///         control characters other than tab and line ends (anything else in a name becomes U+FFFD)
/// out     a hidden group of class inkflate-rough with the strokes in full precision (shown if there is no layer yet), then a
///         group per layer: its area (class fill; with all data to read the outlines back), its runs (class contour and
///         ink, help or closing), its details (class detail)
/// cost    O(samples + pieces)
std::string write_svg(Drawing const& drawing);

}  // namespace inkflate
