// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "geometry/affine.h"
#include "geometry/polyline.h"
#include "image/grid2.h"

namespace inkflate {

/// An area by its contours: where they wind around at all (non-zero).
struct FilledPath {
  std::vector<Contour> contours;
  Colour colour;

  friend bool operator==(FilledPath const&, FilledPath const&) = default;
};

/// How wide a line is at least and at most in the picture that it ends up in, however large or small its list is placed there: so that
/// lines of a large canvas do not fade away, and frames do not grow with what they surround.
struct WidthLimits {
  double least_px = 0;
  double most_px = std::numeric_limits<double>::infinity();

  friend bool operator==(WidthLimits const&, WidthLimits const&) = default;
};

/// A line with round caps and joins. It covers each place once, however often it crosses itself.
struct StrokedPolyline {
  Polyline points;
  std::vector<double> widths_px;  // one for the whole line, or one for each point
  std::vector<double> dashes_px;  // on, off, on, ...; even count, sum > 0; empty: solid. On 0: dots
  Colour colour;
  WidthLimits limits = {};  // dashes follow

  friend bool operator==(StrokedPolyline const&, StrokedPolyline const&) = default;
};

/// Round dots.
struct Dots {
  std::vector<Vec2> centres;
  double diameter_px = 2;
  Colour colour;

  friend bool operator==(Dots const&, Dots const&) = default;
};

/// A picture laid on the canvas.
struct DrawnPicture {
  std::shared_ptr<Picture const> picture;  // null: nothing
  Affine map;                              // from px of the picture
  double opacity = 1;                      // 0 .. 1

  friend bool operator==(DrawnPicture const&, DrawnPicture const&) = default;
};

using DrawItem = std::variant<FilledPath, StrokedPolyline, Dots, DrawnPicture>;

/// What to draw, back to front.
using DrawList = std::vector<DrawItem>;

/// The list moved to another place; widths and dashes grow with the map's mean scale, limits of widths stay.
DrawList place(DrawList list, Affine const& map);

/// Puts one list over another.
void append(DrawList& list, DrawList const& upper);

}  // namespace inkflate
