// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "image/grid2.h"

namespace inkflate {

/// What lies around a sheet.
enum class Surround { Darker, Lighter };

/// A line across the picture as depths from a side, in cells.
struct SheetLine {
  double first = 0;  // at the first cell of the side
  double last = 0;   // at the last

  double depth(double along, int count) const {
    return first + (last - first) * along / std::max(1, count - 1);
  }
};

/// An edge of the sheet, seen from a side.
struct SheetEdge {
  SheetLine line;
  std::vector<char> is_seen;   // by cell along the side
  std::vector<double> depths;  // likewise: where it is seen, else where the line runs
};

/// The edge of a sheet of paper that lies across a picture's first rows.
///
/// in      view: the picture in cells of about a line's width or two, each the mean of its pixels; x along the side from
///         which one looks, y away from it; at least 16 cells each way
/// out     the clearest edge that turns by less than about 12 degrees, if it is seen along a good part of the side
/// cost    O(cells * cells along the side)
std::optional<SheetEdge> find_edge(Picture const& view, Surround surround);

}  // namespace inkflate
