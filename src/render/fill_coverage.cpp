// SPDX-License-Identifier: Apache-2.0
#include "render/fill_coverage.h"

#include <algorithm>
#include <cmath>

namespace inkflate {
namespace {

/// Adds what an edge piece within one row contributes: cells hold the change of coverage from the pixel at
/// their left, so that a running sum over the row gives the signed area to the right of all edges.
void add_piece(Grid2<double>& cells, int row, double x0, double x1, double signed_height) {
  double const width = cells.width;
  double const left = std::min(x0, x1);
  double const right = std::max(x0, x1);
  if (left >= width) return;
  if (right <= 0) {
    cells.at(0, row) += signed_height;
    return;
  }
  double const slope = right > left ? signed_height / (right - left) : 0;
  if (left < 0) cells.at(0, row) += slope * -left;
  double const end = std::min(right, width);
  double from = std::max(left, 0.0);
  for (int column = static_cast<int>(from); column < cells.width && column <= end; ++column) {
    double const to = std::min(end, column + 1.0);
    double const height = right > left ? slope * (to - from) : signed_height;
    double const right_share = 1 - ((from + to) / 2 - column);
    cells.at(column, row) += height * right_share;
    if (column + 1 < cells.width) cells.at(column + 1, row) += height * (1 - right_share);
    if (to >= end) break;
    from = to;
  }
}

/// The edge in the window's own coordinates.
void add_edge(Grid2<double>& cells, Vec2 a, Vec2 b) {
  if (a.y == b.y) return;
  double const direction = a.y < b.y ? 1 : -1;
  if (a.y > b.y) std::swap(a, b);
  double const top = std::max(a.y, 0.0);
  double const bottom = std::min(b.y, static_cast<double>(cells.height));
  if (top >= bottom) return;
  double const slope = (b.x - a.x) / (b.y - a.y);
  double y0 = top;
  double x0 = a.x + (y0 - a.y) * slope;
  while (y0 < bottom) {
    double const row = std::floor(y0);
    double const y1 = std::min(bottom, row + 1);
    double const x1 = y1 == b.y ? b.x : a.x + (y1 - a.y) * slope;
    add_piece(cells, static_cast<int>(row), x0, x1, direction * (y1 - y0));
    y0 = y1;
    x0 = x1;
  }
}

/// A winding area as a share: 0 at 0, 1 from one winding on in either direction, linear between.
double fold(double area) { return std::min(std::abs(area), 1.0); }

}  // namespace

void cover_fill(std::span<Contour const> contours, int left, int top, Grid2<double>& shares) {
  std::fill(shares.values.begin(), shares.values.end(), 0.0);
  if (shares.width == 0) return;
  Vec2 const origin = {static_cast<double>(left), static_cast<double>(top)};
  for (auto const& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      add_edge(shares, contour[i] - origin, contour[(i + 1) % contour.size()] - origin);
    }
  }
  for (int y = 0; y < shares.height; ++y) {
    double area = 0;
    for (int x = 0; x < shares.width; ++x) {
      area += shares.at(x, y);
      shares.at(x, y) = fold(area);
    }
  }
}

}  // namespace inkflate
