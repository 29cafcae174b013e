// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "geometry/affine.h"
#include "geometry/polyline.h"
#include "image/colour.h"

namespace inkflate {

/// An area by its contours, even-odd.
struct FilledPath {
  std::vector<Contour> contours;
  Colour colour;

  friend bool operator==(FilledPath const&, FilledPath const&) = default;
};

/// A line with round caps and joins. It covers each place once, however often it crosses itself.
struct StrokedPolyline {
  Polyline points;
  std::vector<double> widths_px;  // one for the whole line, or one for each point
  std::vector<double> dashes_px;  // on, off, on, ...; even count, sum > 0; empty: solid. On 0: dots
  Colour colour;

  friend bool operator==(StrokedPolyline const&, StrokedPolyline const&) = default;
};

/// Round dots.
struct Dots {
  std::vector<Vec2> centres;
  double diameter_px = 2;
  Colour colour;

  friend bool operator==(Dots const&, Dots const&) = default;
};

using DrawItem = std::variant<FilledPath, StrokedPolyline, Dots>;

/// What to draw, back to front.
using DrawList = std::vector<DrawItem>;

/// The list moved to another place; widths and dashes grow with the map's mean scale.
DrawList place(DrawList list, Affine const& map);

/// Puts one list over another.
void append(DrawList& list, DrawList const& upper);

}  // namespace inkflate
