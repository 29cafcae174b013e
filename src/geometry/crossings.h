// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/polyline.h"

namespace inkflate {

/// Two edges that have a point in common although they should not. Edge i of a contour runs from its point i to the next.
struct Crossing {
  int contour_a = 0;
  int edge_a = 0;
  int contour_b = 0;
  int edge_b = 0;
};

/// All places where contours cross or touch themselves or one another; empty: every contour is simple and they are disjoint.
///
/// in      contours: finite points; fewer than three points, or a repeated point, count as a crossing with itself
/// out     each pair once, at most `most` of them
/// cost    O(n) for contours whose edges are of similar length; exact
std::vector<Crossing> find_crossings(std::span<Contour const> contours, int most);

/// Whether the closed polygon has at least three corners and no edge meets another one, but its neighbours in their common corner.
bool is_simple(Contour const& contour);

}  // namespace inkflate
